"""judge.py FILE FUNCTION [FIELD…]: answers cases by a function of a student's Python file (docs/your-own-code.md).

It is called with origin, direction, t_min, t_max and the shape's fields, or with a query's fields; where FIELDs are given,
for shapes of these fields alone. It returns a list of all answers, one t, None, t, u and v of a triangle, or whether a point
is inside."""

import importlib.util
import json
from pathlib import Path
import sys
import traceback


def numbers(value):
    if isinstance(value, dict):
        return {key: numbers(one) for key, one in value.items()}
    if isinstance(value, list):
        return [numbers(one) for one in value]
    if isinstance(value, str):
        return float.fromhex(value) if "0x" in value else float(value)
    return value if isinstance(value, bool) else float(value)


def arguments_of(case, wanted):
    """What the function is called with; None where it cannot be asked."""
    if "transform" in case:
        return None
    if "query" in case:
        return [numbers(value) for key, value in case.items() if key not in ("id", "precision", "query", "note")]
    ray, shape = {"t_min": 0.0, "t_max": float("inf")} | numbers(case["ray"]), dict(case["shape"])
    shape.pop("type")
    if wanted and list(shape) != wanted:
        return None
    return [ray[key] for key in ("origin", "direction", "t_min", "t_max")] + [numbers(value) for value in shape.values()]


class NoAnswer(Exception):
    """What a function returned that answers nothing."""


def reply(case, said):
    """The answer in the case format."""
    if case.get("query") == "point_in_polygon":
        if said in (0, 1):
            return {"position": "inside" if said else "outside"}
        raise NoAnswer(f"it returned {said!r}: return True or False")
    if isinstance(said, (bool, str)) or said is None and "query" in case:
        raise NoAnswer(f"it returned {said!r}: return {'a list of roots' if 'query' in case else 't, a list of all t, or None'}")
    listed = [] if said is None else [said] if isinstance(said, (int, float)) else list(said)
    if any(isinstance(x, (bool, complex)) or not isinstance(x, (int, float)) for x in listed):
        raise NoAnswer(f"it returned {said!r}: numbers are asked for")
    if "query" in case:
        return {"x": listed}
    if case["shape"]["type"] == "triangle" and len(listed) == 3:
        t, u, v = listed
        return {"verdict": "hit", "hits": [{"t": t}], "barycentric": [1 - u - v, u, v]}
    return {"verdict": "hit" if listed else "miss", "hits": [{"t": t} for t in listed]}


def mistake(problem, file):
    """The exception, with the student's own line."""
    lines = [frame.lineno for frame in traceback.extract_tb(problem.__traceback__) if Path(frame.filename) == file]
    return f"{file.name}, line {lines[-1] if lines else '?'}: {type(problem).__name__}: {problem}"


def line_of(answer, file):
    """The answer as a line, or why it can be none: a set, say, or a number of another library."""
    try:
        return json.dumps(answer)
    except (TypeError, ValueError) as problem:
        return json.dumps({key: answer[key] for key in ("id",) if key in answer} | {"error": mistake(problem, file)})


def main():
    file, name = Path(sys.argv[1]).resolve(), sys.argv[2]
    spec = importlib.util.spec_from_file_location("answer", file)
    module = importlib.util.module_from_spec(spec)
    answers, sys.stdout = sys.stdout, sys.stderr  # what a student prints is no answer
    sys.dont_write_bytecode = True
    spec.loader.exec_module(module)
    function = getattr(module, name)
    for line in sys.stdin:
        case = json.loads(line)
        is_question = isinstance(case, list)  # of a lab's questions.py: the arguments themselves
        arguments = case if is_question else arguments_of(case, sys.argv[3:])
        answer = {} if is_question else {"id": case["id"]}
        try:
            if is_question:
                answer["result"] = function(*arguments)
            else:
                said = None if arguments is None else function(*arguments)
                answer |= {"unsupported": True} if arguments is None else reply(case, said)
        except NoAnswer as problem:
            answer["error"] = str(problem)
        except Exception as problem:  # pylint: disable=broad-except: whatever a student's code throws
            answer["error"] = mistake(problem, file)
        print(line_of(answer, file), file=answers, flush=True)


if __name__ == "__main__":
    main()
