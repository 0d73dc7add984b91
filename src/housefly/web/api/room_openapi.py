"""The OpenAPI document of the HTTP API, generated from its questions and answers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pydantic import TypeAdapter

from housefly.hub.api.answers import ANSWER_TYPES
from housefly.hub.api.endpoints import Endpoint
from housefly.tasks.api.endpoints import TaskEndpoint
from housefly.web.api.tasks_openapi import SCHEMA_REFERENCE, parameter_schema, task_operation

_API_VERSION = "1.0"


def openapi_document(
    endpoints: Sequence[Endpoint], tasks: Sequence[TaskEndpoint], prefix: str
) -> dict[str, Any]:
    """Return the document of what can be asked of the room and of the tasks."""
    schemas: dict[str, Any] = {
        "Error": {
            "type": "object",
            "properties": {"error": {"type": "string"}, "code": {"type": "string"}},
            "required": ["error"],
        }
    }
    paths: dict[str, dict[str, Any]] = {
        prefix + endpoint.path: {"get": _operation(endpoint, schemas)} for endpoint in endpoints
    }
    for task in tasks:
        operation = task_operation(task, schemas)
        paths.setdefault(prefix + task.path, {})[task.method.lower()] = operation
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "Housefly: the room and its tasks",
            "version": _API_VERSION,
            "description": "What is where, what happened, and what is asked for.",
        },
        "security": [{"key": []}],
        "paths": paths,
        "components": {
            "schemas": schemas,
            "securitySchemes": {"key": {"type": "http", "scheme": "bearer"}},
        },
    }


def _operation(endpoint: Endpoint, schemas: dict[str, Any]) -> dict[str, Any]:
    answer = TypeAdapter(ANSWER_TYPES[endpoint.question]).json_schema(
        ref_template=SCHEMA_REFERENCE, mode="serialization"
    )
    schemas.update(answer.pop("$defs", {}))
    name = ANSWER_TYPES[endpoint.question].__name__
    schemas[name] = answer
    described = {
        200: ("the answer", name),
        401: ("no key", "Error"),
        404: ("there is no such thing", "Error"),
        422: ("a parameter is wrong", "Error"),
        503: ("the room's memory does not answer", "Error"),
    }
    return {
        "summary": endpoint.summary,
        "operationId": endpoint.question.__name__.removesuffix("Question").lower(),
        "parameters": _parameters(endpoint),
        "responses": {
            str(status): {
                "description": words,
                "content": {
                    "application/json": {"schema": {"$ref": SCHEMA_REFERENCE.format(model=model)}}
                },
            }
            for status, (words, model) in sorted(described.items())
        },
    }


def _parameters(endpoint: Endpoint) -> list[dict[str, Any]]:
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
                "schema": parameter_schema(own),
            }
        )
    return found
