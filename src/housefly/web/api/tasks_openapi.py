"""The part of the OpenAPI document about the tasks."""

from __future__ import annotations

from typing import Any

from pydantic import TypeAdapter

from housefly.tasks.api.answers import TASK_ANSWER_TYPES
from housefly.tasks.api.endpoints import FILLED_IN, TaskEndpoint

SCHEMA_REFERENCE = "#/components/schemas/{model}"
_REFUSALS = {
    400: "the request is broken",
    401: "no key",
    403: "that is not allowed to you",
    404: "there is no such service, task or place",
    409: "the room does not allow it now",
    413: "too large",
    422: "a parameter is wrong",
    429: "too much at once",
    503: "the services do not answer",
}


def task_operation(endpoint: TaskEndpoint, schemas: dict[str, Any]) -> dict[str, Any]:
    """Return one operation, and add the schemas that it names."""
    answer_type = TASK_ANSWER_TYPES[endpoint.question]
    answer = TypeAdapter(answer_type).json_schema(
        ref_template=SCHEMA_REFERENCE, mode="serialization"
    )
    schemas.update(answer.pop("$defs", {}))
    schemas[answer_type.__name__] = answer
    asked = TypeAdapter(endpoint.question).json_schema(ref_template=SCHEMA_REFERENCE)
    schemas.update(asked.pop("$defs", {}))
    described = {200: ("the answer", answer_type.__name__)}
    described |= {status: (words, "Error") for status, words in _REFUSALS.items()}
    operation: dict[str, Any] = {
        "summary": endpoint.summary,
        "operationId": endpoint.question.__name__.removesuffix("Question"),
        "parameters": _parameters(endpoint, asked),
        "responses": {str(status): _response(*one) for status, one in described.items()},
    }
    if endpoint.method == "POST":
        operation["requestBody"] = _body(endpoint, asked)
    return operation


def parameter_schema(schema: dict[str, Any]) -> dict[str, Any]:
    """Return the schema of a parameter: an optional one may be absent but never null."""
    options = [option for option in schema.get("anyOf", ()) if option.get("type") != "null"]
    kept = {key: value for key, value in schema.items() if key not in ("anyOf", "default", "title")}
    return {**kept, **options[0]} if options else kept


def _parameters(endpoint: TaskEndpoint, asked: dict[str, Any]) -> list[dict[str, Any]]:
    found = []
    for name, own in asked["properties"].items():
        in_path = f"{{{name}}}" in endpoint.path
        if name in ("ask", *FILLED_IN) or not (in_path or endpoint.method == "GET"):
            continue
        required = in_path or name in asked.get("required", ())
        where = "path" if in_path else "query"
        schema = parameter_schema(own)
        found.append({"name": name, "in": where, "required": required, "schema": schema})
    return found


def _body(endpoint: TaskEndpoint, asked: dict[str, Any]) -> dict[str, Any]:
    properties = {
        name: own
        for name, own in asked["properties"].items()
        if name not in ("ask", *FILLED_IN) and f"{{{name}}}" not in endpoint.path
    }
    required = [name for name in asked.get("required", ()) if name in properties]
    schema = {"type": "object", "properties": properties, "additionalProperties": False}
    if required:
        schema["required"] = required
    return {"required": bool(required), "content": {"application/json": {"schema": schema}}}


def _response(words: str, model: str) -> dict[str, Any]:
    schema = {"$ref": SCHEMA_REFERENCE.format(model=model)}
    return {"description": words, "content": {"application/json": {"schema": schema}}}
