# Two commands: `make demo` flies the simulated room with a console, `make test` proves it.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PEERS := tests/peers
CLIENT := src/housefly/web/client
INSTALL := $(BIN)/pip install -q --disable-pip-version-check -c constraints.txt

.PHONY: help setup setup-dev demo test test-fast check format bench client clean

help:
	@echo "make demo       set everything up and fly the simulated room; prints the address of the console"
	@echo "make test       set everything up and run every test"
	@echo "make test-fast  only the tests that need no wire and no browser"
	@echo "make check      format, lint, types, import contracts"
	@echo "make bench      measure, and write docs/results.md"
	@echo "make client     rebuild the console's bundle"

setup: $(VENV)/ready
setup-dev: $(VENV)/ready-dev

$(VENV)/bin/python:
	$(PYTHON) -m venv $(VENV)

$(VENV)/ready: pyproject.toml constraints.txt | $(VENV)/bin/python
	@echo "installing Housefly (once, about a minute)"
	@scripts/system-packages optional libosmesa6 mosquitto & packages=$$!; \
	$(INSTALL) -e '.[twin,lab]' && wait $$packages
	@$(BIN)/python -m housefly.app.warm_up
	@touch $@

$(VENV)/ready-dev: pyproject.toml constraints.txt $(PEERS)/package-lock.json $(CLIENT)/package-lock.json | $(VENV)/bin/python
	@echo "installing Housefly and what its tests need (once, a few minutes)"
	@scripts/system-packages required libosmesa6 chromium libatomic1 mosquitto postgresql & packages=$$!; \
	$(INSTALL) -e '.[dev]' && npm ci --silent --no-audit --no-fund --prefix $(PEERS) && \
	npm ci --silent --no-audit --no-fund --prefix $(CLIENT) && wait $$packages
	@$(BIN)/python -m housefly.app.warm_up
	@touch $@ $(VENV)/ready

demo: setup
	@$(BIN)/housefly demo

test: setup-dev
	$(BIN)/python -m pytest -q -n 2 --dist worksteal -m 'not wire and not browser'
	$(BIN)/python -m pytest -q -n 2 --dist worksteal -m 'wire or browser'

test-fast: setup-dev
	$(BIN)/python -m pytest -q -n 2 --dist worksteal -m 'not wire and not browser and not slow'

check: setup-dev
	$(BIN)/ruff format --check src tests benchmarks examples
	$(BIN)/ruff check src tests benchmarks examples
	$(BIN)/mypy
	$(BIN)/lint-imports

format: setup-dev
	$(BIN)/ruff format src tests benchmarks examples
	$(BIN)/ruff check --fix src tests benchmarks examples

bench: setup-dev
	$(BIN)/python benchmarks/run.py

client: setup-dev
	npm run --silent --prefix $(CLIENT) build

clean:
	rm -rf $(VENV) $(PEERS)/node_modules $(CLIENT)/node_modules
