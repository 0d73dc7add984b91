"""What changed since the last time, told by the whole service beside a true memory; no flight."""

from __future__ import annotations

import time
from pathlib import Path

from task_stage import TaskStage

from housefly.messages import Observation
from housefly.tasks.api.questions import CancelTask, RequestTask, TaskHistoryQuestion
from housefly.tasks.api.values import TaskStage as Stage

COMPARES = "name: compare\nsteps:\n  - wait: 1 s\n  - changes\n"


class House:
    """A stage whose things are put somewhere."""

    def __init__(self, folder: Path) -> None:
        documents = folder / "documents"
        documents.mkdir()
        (documents / "compare.yaml").write_text(COMPARES)
        self.stage = TaskStage(folder, tasks__documents=str(documents))
        self.pass_time(0.5)

    def pass_time(self, seconds: float) -> None:
        """Let time pass for the tasks, and then for the memory, whose clock is the true one."""
        self.stage.stand(seconds)
        time.sleep(max(0.0, self.stage.wall() - time.time()) + 0.02)

    def put(self, thing: str, x: float) -> None:
        assert self.stage.hub is not None
        now = time.time()
        self.stage.hub.memory.add(Observation(thing, "vicon", now, now, (x, 2.0, 0.8)))
        self.stage.hub.memory.flush()

    def request(self) -> int:
        number: int = self.stage.ask(RequestTask("compare", {}, by="kim")).tasks[0].id
        self.pass_time(0.3)
        return number

    def report(self) -> tuple[str, ...]:
        task = self.request()
        self.pass_time(1.2)
        ended = {each.id: each for each in self.stage.ask(TaskHistoryQuestion()).tasks}[task]
        assert ended.state is Stage.DONE, ended
        report: tuple[str, ...] = ended.report
        return report

    def cancel(self) -> None:
        self.stage.ask(CancelTask(self.request(), "kim"))
        self.pass_time(0.3)


def test_each_round_tells_what_changed_since_the_one_before(tmp_path: Path) -> None:
    house = House(tmp_path)
    try:
        house.put("cup", 5.0)
        house.put("book", 6.0)
        assert house.report() == ("Done for the first time: there is nothing to compare with yet",)
        (still,) = house.report()
        assert still.startswith("Nothing came, went or moved in the last")
        house.put("cup", 7.5)
        house.cancel()  # told nobody: the next round does
        assert house.report() == ("Cup moved by 2.5 m",)
        (still,) = house.report()
        assert still.startswith("Nothing")
    finally:
        house.stage.close()
