"""The OpenAPI document of the room's API, made from the questions and their answers themselves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

from pydantic import TypeAdapter

from housefly.hub.api.answers import ANSWERS
from housefly.hub.api.questions import Question

VERSION = "1.0"
REFERENCE = "#/components/schemas/{model}"


class Described(Protocol):
    """What is told of one path."""

    @property
    def path(self) -> str:
        """Below the prefix, with its parameter in braces."""
        ...

    @property
    def question(self) -> type[Question]:
        """Whose fields are the parameters."""
        ...

    @property
    def summary(self) -> str:
        """One line."""
        ...


def openapi(endpoints: Sequence[Described], prefix: str) -> dict[str, Any]:
    """Return the document."""
    schemas: dict[str, Any] = {
        "Error": {
            "type": "object",
            "properties": {"error": {"type": "string"}},
            "required": ["error"],
        }
    }
    paths = {
        prefix + endpoint.path: {"get": _operation(endpoint, schemas)} for endpoint in endpoints
    }
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "Housefly: the room",
            "version": VERSION,
            "description": "What is where, and what happened.",
        },
        "security": [{"key": []}],
        "paths": paths,
        "components": {
            "schemas": schemas,
            "securitySchemes": {"key": {"type": "http", "scheme": "bearer"}},
        },
    }


def _operation(endpoint: Described, schemas: dict[str, Any]) -> dict[str, Any]:
    answer = TypeAdapter(ANSWERS[endpoint.question]).json_schema(
        ref_template=REFERENCE, mode="serialization"
    )
    schemas.update(answer.pop("$defs", {}))
    name = ANSWERS[endpoint.question].__name__
    schemas[name] = answer
    described = {
        200: ("the answer", name),
        401: ("no key", "Error"),
        422: ("a parameter is wrong", "Error"),
    }
    described |= {
        404: ("there is no such thing", "Error"),
        503: ("the room's memory does not answer", "Error"),
    }
    return {
        "summary": endpoint.summary,
        "operationId": endpoint.question.__name__.lower(),
        "parameters": _parameters(endpoint),
        "responses": {
            str(status): {
                "description": words,
                "content": {
                    "application/json": {"schema": {"$ref": REFERENCE.format(model=model)}}
                },
            }
            for status, (words, model) in sorted(described.items())
        },
    }


def _parameters(endpoint: Described) -> list[dict[str, Any]]:
    schema = TypeAdapter(endpoint.question).json_schema()
    found = []
    for name, own in schema["properties"].items():
        if name == "ask":
            continue
        in_path = f"{{{name}}}" in endpoint.path
        required = in_path or name in schema.get("required", ())
        found.append(
            {
                "name": name,
                "in": "path" if in_path else "query",
                "required": required,
                "schema": _plain(own),
            }
        )
    return found


def _plain(schema: dict[str, Any]) -> dict[str, Any]:
    """Return the schema of a parameter: one that may be left out is never given as null."""
    options = [option for option in schema.get("anyOf", ()) if option.get("type") != "null"]
    kept = {key: value for key, value in schema.items() if key not in ("anyOf", "default", "title")}
    return {**kept, **options[0]} if options else kept
