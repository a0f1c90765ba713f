"""The corpus, and cases of all families, in portions of one topic."""

from collections import Counter
from itertools import islice
import subprocess

PORTION = 20000


def families(programs):
    """How many families each topic has."""
    listing = subprocess.run([programs / "rayproof-cases", "--list"], capture_output=True, text=True, check=True)
    return Counter(line.split()[0] for line in listing.stdout.splitlines())


def portions(source, programs, topic, count, seed):
    """Lists of lines: first the corpus, then `count` cases of each family and precision."""
    corpus = (source / f"property_tests/corpus/{topic}.jsonl").read_bytes().splitlines(True)
    yield [line for line in corpus if line.strip()]
    command = [programs / "rayproof-cases", "--topic", topic, "--count", str(count), "--seed", str(seed)]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
        while lines := list(islice(process.stdout, PORTION)):
            yield lines
    if process.returncode != 0:
        raise RuntimeError(f"rayproof-cases ends with {process.returncode}")
