"""What a schema forbids, rule by rule, and which of its rules an instance breaks."""

from jsonschema import Draft202012Validator

BARE = {"type", "enum", "pattern", "minLength", "maxLength", "minItems", "maxItems", "minimum", "maximum",
        "maxProperties", "oneOf", "anyOf", "not"}
BELOW_NAMES = {"properties", "$defs"}


def rules(schema, place=""):
    """The places of all rules: "/properties/name/type", one for each name under required."""
    found = set()
    for key, value in schema.items():
        here = f"{place}/{key}"
        if key == "required":
            found |= {f"{here}/{name}" for name in value}
        elif key == "additionalProperties" and value is False:
            found.add(here)
        elif key in BARE:
            found.add(here)
        if key in BELOW_NAMES:
            for name, below in value.items():
                found |= rules(below, f"{here}/{name}")
        elif isinstance(value, dict):
            found |= rules(value, here)
        elif isinstance(value, list) and key in {"oneOf", "anyOf", "allOf"}:
            for i, below in enumerate(value):
                found |= rules(below, f"{here}/{i}")
    # Inside a "not" a rule is broken when the instance is right.
    return {rule for rule in found if "/not/" not in rule}


def flat(errors):
    for error in errors:
        yield error
        yield from flat(error.context)


def place_of(schema, path):
    """The place in the schema itself of a path, which does not say where it went through a $ref."""
    place = []
    node = schema
    for key in path:
        while isinstance(node, dict) and key not in node and "$ref" in node:
            place = node["$ref"].removeprefix("#/").split("/")
            node = schema
            for name in place:
                node = node[name]
            place = list(place)
        node = node[key]
        place.append(str(key))
    return "".join(f"/{key}" for key in place)


def broken_rules(schema, instance):
    result = set()
    for error in flat(Draft202012Validator(schema).iter_errors(instance)):
        place = place_of(schema, error.absolute_schema_path)
        if error.validator == "required":
            result |= {f"{place}/{name}" for name in error.validator_value if name not in error.instance}
        else:
            result.add(place)
    return result
