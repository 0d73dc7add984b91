"""How a run begins."""

from __future__ import annotations

from pathlib import Path

from task_stage import TaskStage

from housefly.messages import OrderKind
from housefly.tasks.api.questions import RequestTask

ONE_TICK = 1.0 / 15.0


def test_the_tick_that_hears_of_a_good_rehearsal_gives_the_first_order(tmp_path: Path) -> None:
    stage = TaskStage(tmp_path, hub__enabled=False)
    stage.rehearsals.is_slow = True
    stage.stand()
    stage.ask(RequestTask("look", {"subject": "tv"}, by="kim"))
    stage.stand()
    assert stage.orders == []
    stage.rehearsals.finish()
    stage.stand(ONE_TICK)
    stage.close()
    assert [order.kind for order in stage.orders] == [OrderKind.GO]
