"""One run to one memory, also where a server keeps it."""

from __future__ import annotations

import os
from typing import Any

import pytest
from store_holder import held_elsewhere

from housefly.config.site import Site, changed
from housefly.errors import StoreError
from housefly.hub.store.lock import locked_store, refuse_shared_store
from housefly.hub.store.open import open_store

pytestmark = pytest.mark.wire


def test_a_database_that_another_process_holds_is_refused_until_it_is_gone(server: Any) -> None:
    store, elsewhere = server.new_database(), server.new_database()
    site = changed(Site(), hub__store=store)
    with held_elsewhere(store) as other:
        words = f"another run uses this room's memory.*process {other}.*house_.*hub.store"
        with pytest.raises(StoreError, match=words):
            refuse_shared_store(site)
        with pytest.raises(StoreError, match=words), locked_store(site):
            pass
        open_store(store).close()  # who only looks, as `housefly memory` does, is not kept out
        with locked_store(changed(Site(), hub__store=elsewhere)):
            pass
    refuse_shared_store(site)
    with locked_store(site):
        pass


def test_the_words_of_a_refusal_hold_no_password(server: Any) -> None:
    store = server.new_database().replace("@/", ":hidden@/", 1)
    site = changed(Site(), hub__store=store)
    with (
        locked_store(site),
        pytest.raises(StoreError, match=f"process {os.getpid()}") as refused,
        locked_store(site),
    ):
        pass
    assert "hidden" not in str(refused.value)


def test_a_server_that_does_not_answer_is_for_the_hub_to_tell(tmp_path: Any) -> None:
    site = changed(Site(), hub__store=f"postgresql://room@/house?host={tmp_path}")
    refuse_shared_store(site)
    pytest.importorskip("psycopg")
    with pytest.raises(StoreError, match="does not answer"), locked_store(site):
        pass
