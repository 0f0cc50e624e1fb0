"""The JSON schemas under experiments/docs agree with the program: what it reads, what it writes, what it refuses."""

import copy
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("Skipped: python3-jsonschema is missing; 'experiments/setup --lint' installs it")
    sys.exit(77)

from rules import broken_rules, rules

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("SUBDIVLAB_PROGRAM", str(ROOT / "build/subdivlab"))
NAMES = ["scheme", "claims", "analyze", "certify", "optimize", "eigen", "own-claims"]
SCHEMAS = {name: json.loads((ROOT / f"experiments/docs/{name}.schema.json").read_text()) for name in NAMES}


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def is_valid(name, instance):
    return Draft202012Validator(SCHEMAS[name]).is_valid(instance)


def first_error(name, instance):
    errors = Draft202012Validator(SCHEMAS[name]).iter_errors(instance)
    return next((f"{list(error.absolute_path)}: {error.message}" for error in errors), "")


HAT = '"mask": {"first": -1, "coefficients": ["1/2", 1, "1/2"]}'
HEAD = '{"name": "x", "arity": 2'


def file_with(rest):
    return HEAD + ", " + rest + "}"


def mask_of(coefficients, first="-1"):
    return file_with(f'"mask": {{"first": {first}, "coefficients": {coefficients}}}')


GOOD = {
    "a mask": file_with(HAT),
    "numbers and decimals": mask_of('[0.5, "1", 5e-1]'),
    "white space": mask_of('[" 1 / 2 ", "1\\t", "(1)/2\\n"]'),
    "a parameter": file_with('"parameters": {"w": "1/16"}, "mask": {"first": -3, "coefficients": '
                             '["-w", 0, "1/2+w", 1, "1/2+w", 0, "-w"]}'),
    "a default with a root": file_with('"parameters": {"w_1": "sqrt(3)/20"}, "mask": {"first": -1, "coefficients": '
                                       '["1/2-w_1", "1", "1/2+w_1"]}'),
    "a default with an exponent": file_with('"parameters": {"a": "-2.5E-1"}, "symbol": "(1+z)^2/(2*z)*(1+a)/(1+a)"'),
    "no parameters": file_with('"parameters": {}, ' + HAT),
    "a symbol": file_with('"symbol": "2*((1+z)/2)^4"'),
    "a symbol with negative powers": file_with('"symbol": "z^(-2)*2*((1+z)/2)^4"'),
    "arity 3": '{"name": "x", "arity": 3, "symbol": "(1+z+z^2)^2/3"}',
    "a source": file_with(HAT + ', "source": ""'),
    "the farthest mask": mask_of('["1/2", "1", "1/2"]', "-10000"),
    "a long name": '{"name": "' + "n" * 200 + '", "arity": 2, ' + HAT + "}",
}

# Refused by the schema and by the program.
BAD = {
    "a list": "[]",
    "no name": '{"arity": 2, ' + HAT + "}",
    "a number for a name": '{"name": 5, "arity": 2, ' + HAT + "}",
    "a blank name": '{"name": " \\t", "arity": 2, ' + HAT + "}",
    "a name too long": '{"name": "' + "n" * 201 + '", "arity": 2, ' + HAT + "}",
    "no arity": '{"name": "x", ' + HAT + "}",
    "arity 4": '{"name": "x", "arity": 4, ' + HAT + "}",
    "arity in quotes": '{"name": "x", "arity": "2", ' + HAT + "}",
    "an unknown key": file_with(HAT + ', "masks": 1'),
    "neither mask nor symbol": HEAD + "}",
    "mask and symbol": file_with(HAT + ', "symbol": "(1+z)^2/2"'),
    "a source that is no text": file_with(HAT + ', "source": 1974'),
    "parameters in a list": file_with('"parameters": ["w"], ' + HAT),
    "a name with a dash": file_with('"parameters": {"w-1": 1}, ' + HAT),
    "a name with a digit ahead": file_with('"parameters": {"1w": 1}, ' + HAT),
    "the name z": file_with('"parameters": {"z": 1}, ' + HAT),
    "the name sqrt": file_with('"parameters": {"sqrt": 1}, ' + HAT),
    "the name NaN": file_with('"parameters": {"NaN": 1}, ' + HAT),
    "the name infinity": file_with('"parameters": {"Infinity": 1}, ' + HAT),
    "a default with a name": file_with('"parameters": {"w": "v/2"}, ' + HAT),
    "a default that is no number": file_with('"parameters": {"w": null}, ' + HAT),
    "an empty default": file_with('"parameters": {"w": ""}, ' + HAT),
    "too many parameters": file_with('"parameters": {' + ", ".join(f'"w{i}": 1' for i in range(1001)) + "}, " + HAT),
    "a mask that is a list": file_with('"mask": ["1/2", 1, "1/2"]'),
    "a mask without first": file_with('"mask": {"coefficients": ["1/2", 1, "1/2"]}'),
    "a mask without coefficients": file_with('"mask": {"first": -1}'),
    "an unknown key of the mask": file_with('"mask": {"first": -1, "coefficients": ["1/2", 1, "1/2"], "last": 1}'),
    "first in quotes": mask_of('["1/2", 1, "1/2"]', '"-1"'),
    "first with a half": mask_of('["1/2", 1, "1/2"]', "-1.5"),
    "first too small": mask_of('["1/2", 1, "1/2"]', "-10001"),
    "first too large": mask_of('["1/2", 1, "1/2"]', "10001"),
    "coefficients in a text": mask_of('"1/2, 1, 1/2"'),
    "no coefficients": mask_of("[]"),
    "too many coefficients": mask_of("[" + ", ".join(["0"] * 1001) + "]"),
    "a coefficient that is true": mask_of('["1/2", true, "1/2"]'),
    "a coefficient in a list": mask_of('["1/2", [1], "1/2"]'),
    "a comma in a number": mask_of('["0,5", 1, "1/2"]'),
    "a minus that is none": mask_of('["1/2", "1", "\u22121/2"]'),
    "an empty coefficient": mask_of('["1/2", "1", ""]'),
    "a coefficient that ends in a sign": mask_of('["1/2", "1", "1/2+"]'),
    "a symbol in a list": file_with('"symbol": ["(1+z)^2/2"]'),
    "a symbol without end": file_with('"symbol": "(1+z)^2/2*"'),
    "a symbol too long": file_with('"symbol": "' + "0+" * 50000 + '(1+z)^2/2"'),
}

# What a schema cannot say: refused by the program alone.
BEYOND = {
    "coefficients that miss the arity": mask_of('["1/2", 1, "1/4"]'),
    "an undeclared name": mask_of('["1/2", 1, "w"]'),
    "parentheses without end": mask_of('["1/2", 1, "(1/2"]'),
    "two signs of a product": mask_of('["1/2", 1, "1//2"]'),
    "division by zero": mask_of('["1/2", 1, "1/0"]'),
    "a name of 300 bytes": '{"name": "' + "\u00e9" * 150 + '", "arity": 2, ' + HAT + "}",
    "a key twice": file_with(HAT + ', "arity": 2'),
    "arity with a point": '{"name": "x", "arity": 2.0, ' + HAT + "}",
    "a default that divides by zero": file_with('"parameters": {"w": "1/0"}, "mask": {"first": -1, "coefficients": '
                                                '["1/2", "1+w", "1/2-w"]}'),
}


class SchemeFiles(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name) / "scheme.json"

    def tearDown(self):
        self.folder.cleanup()

    def reader_accepts(self, text):
        self.path.write_text(text, encoding="utf-8")
        answer = run("analyze", self.path, "--budget", "1")
        self.assertIn(answer.returncode, {0, 2, 3}, answer.stderr)
        return answer.returncode != 2

    def test_good_files_are_good_for_both(self):
        for what, text in GOOD.items():
            with self.subTest(what):
                self.assertEqual(first_error("scheme", json.loads(text)), "")
                self.assertTrue(self.reader_accepts(text), run("analyze", self.path).stderr)

    def test_bad_files_are_bad_for_both(self):
        for what, text in BAD.items():
            with self.subTest(what):
                self.assertFalse(is_valid("scheme", json.loads(text)))
                self.assertFalse(self.reader_accepts(text))

    def test_what_a_schema_cannot_say_is_refused_by_the_program(self):
        for what, text in BEYOND.items():
            with self.subTest(what):
                self.assertTrue(is_valid("scheme", json.loads(text)))
                self.assertFalse(self.reader_accepts(text))

    def test_every_rule_is_broken_by_a_bad_file(self):
        broken = set()
        for text in BAD.values():
            broken |= broken_rules(SCHEMAS["scheme"], json.loads(text))
        self.assertEqual(rules(SCHEMAS["scheme"]) - broken, set())

    def test_files_of_the_project(self):
        texts = [p.read_text() for p in sorted(ROOT.glob("experiments/**/*.json")) if ".schema." not in p.name]
        files = [text for text in texts if {"arity"} <= set(json.loads(text))]
        pages = [ROOT / "README.md", *sorted(ROOT.glob("experiments/docs/*.md"))]
        for page in pages:
            files += [block for block in re.findall(r"```json\n(.*?)```", page.read_text(), re.S) if '"arity"' in block]
        self.assertGreaterEqual(len(files), 1)
        for text in files:
            with self.subTest(text):
                self.assertEqual(first_error("scheme", json.loads(text)), "")
                self.assertTrue(self.reader_accepts(text))


class Claims(unittest.TestCase):
    def setUp(self):
        everything = json.loads((ROOT / "results/claims.json").read_text())
        self.everything = everything
        chosen = [next(c for c in everything["claims"] if (c["value"]["lower"] is None) == none) for none in (True, False)]
        self.small = {"claims": copy.deepcopy(chosen)}

    def reader_refuses(self, instance):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "claims.json").write_text(json.dumps(instance))
            answer = run("check", "family.members.cubic", "--against", folder)
            self.assertIn(answer.returncode, {0, 1, 2}, answer.stderr)
            return answer.returncode == 2

    def broken(self):
        """Instances with one thing wrong, by what is wrong."""
        result = {"a list": [], "no claims": {}, "claims in an object": {"claims": {}}, "a claim that is none": {"claims": [1]}}
        claim = self.small["claims"][1]
        for key in claim:
            without = copy.deepcopy(self.small)
            del without["claims"][1][key]
            result[f"no {key}"] = without
            wrong = copy.deepcopy(self.small)
            wrong["claims"][1][key] = 7
            result[f"{key} is a number"] = wrong
        for key in ("kind", "rigour", "verdict"):
            wrong = copy.deepcopy(self.small)
            wrong["claims"][0][key] = "proven"
            result[f"an unknown {key}"] = wrong
        for key, value in (("lower", 1), ("upper", "about 2"), ("lower", None), ("upper", None), ("exact", 3)):
            wrong = copy.deepcopy(self.small)
            wrong["claims"][1]["value"][key] = value
            result[f"{key}: {value}"] = wrong
        for key in ("lower", "upper"):
            wrong = copy.deepcopy(self.small)
            del wrong["claims"][1]["value"][key]
            result[f"no {key}"] = wrong
        wrong = copy.deepcopy(self.small)
        wrong["claims"][0]["value"]["lower"] = "1"
        result["a lower end alone"] = wrong
        return result

    def test_committed_claims(self):
        self.assertEqual(first_error("claims", self.everything), "")
        self.assertGreater(len(self.everything["claims"]), 700)
        self.assertFalse(self.reader_refuses(self.everything))

    def test_broken_claims_are_refused_by_both(self):
        for what, instance in self.broken().items():
            with self.subTest(what):
                self.assertFalse(is_valid("claims", instance))
                self.assertTrue(self.reader_refuses(instance))

    def test_every_rule_is_broken_by_one_of_them(self):
        broken = set()
        for instance in self.broken().values():
            broken |= broken_rules(SCHEMAS["claims"], instance)
        self.assertEqual(rules(SCHEMAS["claims"]) - broken, set())


ANSWERS = {
    "analyze": [
        ["jspline:s=3/2"], ["jspline:a=1,b=-3/4"], ["four-point:w=1"], ["jspline:s=s"], ["four-point:w=w"], ["jspline:a=a,b=b"],
        ["four-point:w=sqrt(2)/20"], ["jspline:s=-33/26+jspline:s=3/2"], ["bspline:degree=2"], ["bspline:degree=1"],
        ["deslauriers-dubuc:points=6"], ["dyn-floater-hormann"], ["four-point:w=1/5"], ["jspline:s=1.27", "--budget", "0.01"],
        ["ternary.json"], ["rounded.json", "--rounded"], ["long.json"],
    ],
    "certify": [
        ["four-point:w=w", "--over", "w=-1/4..1/4", "--continuity", "1"],
        ["jspline:s=s", "--over", "s=-3..7", "--continuity", "1", "--budget", "5"],
        ["jspline:a=a,b=b", "--over", "a=0..1,b=0..1", "--continuity", "1", "--budget", "2"],
        ["jspline:s=s", "--over", "s=1/2..1/2", "--continuity", "3"],
        ["dyn-floater-hormann:w=w", "--over", "w=-1/20..-1/30", "--continuity", "2"],
    ],
    "optimize": [
        ["jspline:s=r+jspline:s=3/2", "--over", "r=-2..2", "--objective", "vertex", "--norm", "linf"],
        ["jspline:s=s", "--over", "s=0..3/2", "--objective", "area", "--norm", "l2"],
        ["jspline:s=s", "--over", "s=0..1", "--objective", "fit-bspline:degree=2", "--norm", "l1"],
        ["jspline:s=s", "--over", "s=0..3/2", "--objective", "area", "--polygon", ROOT / "experiments/data/figure-shape.csv"],
    ],
    "eigen": [
        ["catmull-clark", "--valence", "3..6"], ["loop", "--valence", "3"], ["jspline-mesh:s=3/2", "--valence", "5"],
        ["jspline-mesh:s=s", "--valence", "5", "--over", "s=-2..6"], ["adjustable-speed:sigma=3/4", "--valence", "5"],
    ],
}


class Answers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        (folder / "ternary.json").write_text(GOOD["arity 3"])
        (folder / "rounded.json").write_text(mask_of("[0.3333, 0.6667, 0.6667, 0.3333]", "-1"))
        (folder / "long.json").write_text(file_with('"symbol": "2*((1+z)/2)^60"'))
        cls.answers = {}
        for verb, questions in ANSWERS.items():
            cls.answers[verb] = []
            for question in questions:
                answer = subprocess.run([PROGRAM, verb, *map(str, question), "--json"], capture_output=True, text=True,
                                        timeout=300, cwd=folder)
                cls.answers[verb].append((question, answer))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_answers_are_as_described(self):
        for verb, answers in self.answers.items():
            for question, answer in answers:
                with self.subTest(verb=verb, question=question):
                    self.assertIn(answer.returncode, {0, 3}, answer.stderr)
                    self.assertEqual(first_error(verb, json.loads(answer.stdout)), "")

    def test_a_wrong_value_anywhere_is_noticed(self):
        for verb, answers in self.answers.items():
            for question, answer in answers[:3]:
                instance = json.loads(answer.stdout)
                for path in places(instance):
                    wrong = put(copy.deepcopy(instance), path, {"wrong": []})
                    with self.subTest(verb=verb, question=question, path=path):
                        self.assertFalse(is_valid(verb, wrong))

    def test_every_property_occurs(self):
        for verb, answers in self.answers.items():
            seen = set()
            for _, answer in answers:
                seen |= keys(json.loads(answer.stdout))
            described = set()
            for place in rules(SCHEMAS[verb]):
                described |= set(re.findall(r"/required/(\w+)$", place))
            self.assertEqual(described - seen, set(), verb)


def places(value, path=()):
    if path:
        yield path
    below = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else []
    for key, inner in below:
        yield from places(inner, (*path, key))


def put(value, path, replacement):
    node = value
    for key in path[:-1]:
        node = node[key]
    node[path[-1]] = replacement
    return value


def keys(value):
    if isinstance(value, dict):
        return set(value).union(*map(keys, value.values()))
    return set().union(*map(keys, value)) if isinstance(value, list) else set()


class OwnClaims(unittest.TestCase):
    def definitions(self):
        return json.loads(run("list", "definitions", "--json").stdout)["definitions"]

    def test_it_knows_the_definitions_and_their_arguments(self):
        described = {}
        for entry in SCHEMAS["own-claims"]["$defs"]["definition"]["oneOf"]:
            described[entry["properties"]["name"]["const"]] = (set(entry["properties"]), set(entry["required"]))
        for definition in self.definitions():
            arguments = definition["arguments"]
            self.assertEqual(described.pop(definition["name"]),
                             ({"name", *(a["name"] for a in arguments)},
                              {"name", *(a["name"] for a in arguments if a["required"])}))
        self.assertEqual(described, {})

    def test_examples_are_good(self):
        for definition in self.definitions():
            with self.subTest(definition["name"]):
                self.assertEqual(first_error("own-claims", {"claims": [{"id": "a", "definition": definition["example"]}]}), "")

    def test_bad_files_are_bad_for_both(self):
        good = {"id": "a", "definition": {"name": "hoelder", "scheme": "four-point"}}
        bad = [[], {}, {"claims": {}}, {"claims": [good], "claim": 1}, {"claims": [7]}, {"document": 7, "claims": [good]},
               {"figures": [{"name": "f"}]}, {"figures": [{"name": "a b", "scheme": "four-point"}]}]
        changes = [{"id": "a b"}, {"id": ".a"}, {"id": 7}, {"kind": "exact"}, {"kind": "bound", "printed": "2"},
                   {"printed": ["2"]}, {"definition": "hoelder"}, {"definition": {"name": "holder", "scheme": "four-point"}},
                   {"definition": {"name": "hoelder"}}, {"value": 2}, {"section": 4},
                   {"definition": {"name": "hoelder", "scheme": "four-point", "index": 1}},
                   {"definition": {"name": "hoelder", "scheme": ["four-point"]}}]
        bad += [{"claims": [{**good, **change}]} for change in changes]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "mine.json"
            for instance in bad:
                with self.subTest(instance=instance):
                    path.write_text(json.dumps(instance))
                    answer = run("reproduce", "--claims", path, "--out", pathlib.Path(folder) / "out")
                    self.assertEqual(answer.returncode, 2, answer.stderr)
                    self.assertFalse(is_valid("own-claims", instance))
                    self.assertFalse((pathlib.Path(folder) / "out").exists())


class Schemas(unittest.TestCase):
    def test_they_are_schemas(self):
        for path in sorted(ROOT.glob("experiments/docs/*.schema.json")):
            with self.subTest(path.name):
                schema = json.loads(path.read_text())
                Draft202012Validator.check_schema(schema)
                self.assertIn("description", schema)
        for name, schema in SCHEMAS.items():
            self.assertEqual(schema["$id"], f"urn:subdivlab:{name}")


if __name__ == "__main__":
    unittest.main()
