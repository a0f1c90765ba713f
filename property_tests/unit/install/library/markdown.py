"""The blocks of code in a document, and the examples in the comments of a header."""

import re


def section(document, title):
    """The text under a heading of the second level."""
    parts = re.split(r"^## (.*)\n", document.read_text(), flags=re.MULTILINE)
    return parts[parts.index(title) + 1]


def blocks(text, language):
    """All fenced blocks of one language; "" for those without a language."""
    found = re.findall(r"^```(\w*)\n(.*?)^```$", text, flags=re.MULTILINE | re.DOTALL)
    return [body for language_of_it, body in found if language_of_it == language]


def examples(header):
    """What stands between \\code and \\endcode in comments, without the comment's slashes."""
    comments = re.sub(r"^ *//[/!]?<? ?", "", header.read_text(), flags=re.MULTILINE)
    return re.findall(r"[\\@]code(?:{\.\w+})?\n(.*?)[\\@]endcode", comments, flags=re.DOTALL)
