"""What is paused while it is still rehearsed does not take off, in the whole task service."""

from __future__ import annotations

from pathlib import Path

from task_stage import TaskStage

from housefly.messages import OrderKind
from housefly.tasks.api.questions import ContinueTask, PauseTask, RequestTask
from housefly.tasks.api.values import TaskStage as Stage


def test_a_task_that_is_paused_before_its_first_order_waits_for_a_person(tmp_path: Path) -> None:
    stage = TaskStage(tmp_path)
    try:
        stage.stand()
        stage.rehearsals.is_slow = True
        stage.ask(RequestTask("look", {"subject": "refrigerator"}, by="kim"))
        stage.stand()
        assert stage.task().state is Stage.RUNNING
        stage.ask(PauseTask(1, by="kim"))
        record = stage.parts.engine._runs.record(1)
        assert record is not None and record.rehearsal is not None
        record.rehearsal.set_result(stage.rehearsals.report)
        stage.rehearsals.is_slow = False
        stage.stand(3.0)
        assert stage.task().state is Stage.PAUSED and stage.new_orders() == []
        stage.ask(ContinueTask(1, by="kim"))
        stage.stand()
        assert stage.new_orders()[0].kind is OrderKind.GO
    finally:
        stage.close()
