# Two commands: `make demo` flies the simulated room with a console, `make test` proves it.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
TOOLS := $(VENV)/tools
# The makers' library flies the simulated Tello: it brings OpenCV, so it lives apart.
TELLOPY := $(VENV)/djitellopy
# Bitcraze's own library flies the twin: GPL, and with versions of its own, so it lives apart.
CFLIB := $(VENV)/cflib
# An MSP library flies the simulated Betaflight: GPL, so it lives apart.
YAMSPY := $(VENV)/yamspy
# The client of rosbridge brings Twisted, so it lives apart.
ROSLIBPY := $(VENV)/roslibpy
# Home Assistant is shown the room: it pins a hundred packages, so it lives apart.
HOME_ASSISTANT := $(VENV)/homeassistant
PEERS := tests/peers
CLIENT := src/housefly/web/client
FUZZ_SECONDS ?= 30
CODE := src tests benchmarks examples scripts
PYTEST := $(BIN)/python -m pytest -q --dist worksteal --durations=10 --durations-min=1 \
	--hypothesis-profile=same-examples
# Only what has such tests is imported for the few that are marked.
marked = $(shell grep -rl --include='test_*.py' 'mark\.$(1)' tests)
REALTIME := $(PYTEST) -n 1
# What failed beside others is run once more, alone: a machine that stood still passes, a defect
# fails again. Both results are printed; who maintains this looks at both.
run_tests = $(PYTEST) --cache-clear -n $(1) -m $(2) $(3) || { [ $$? -eq 1 ] && \
	echo "==== once more, alone: what failed above ====" && \
	$(PYTEST) -n 0 --last-failed --last-failed-no-failures none -m $(2); }
# Tests start hundreds of processes: what they import is compiled once.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: help setup setup-dev demo test interop safety branches fuzz test-fast check format bench client lock audit clean

help:
	@echo "make demo       set everything up and fly the simulated room; prints the address of the console"
	@echo "make test       set everything up and run the tests (interop and safety fly more)"
	@echo "make interop    more flights over real wires: tracking rates and systems, endings, tasks, console"
	@echo "make safety     fly every fault in every phase, with and without guards; writes docs/safety-case.html"
	@echo "make branches   which branches of the safety gate its own tests reach; fails below 100 %"
	@echo "make fuzz       fuzz every parser, FUZZ_SECONDS (30) each; keeps what it finds"
	@echo "make test-fast  only the tests that need no wire and no browser"
	@echo "make check      format, lint, types, import contracts"
	@echo "make bench      measure, and write docs/results.md"
	@echo "make client     rebuild the console's bundle"
	@echo "make lock       write requirements/*.txt anew, with hashes, after a change of a version"
	@echo "make audit      ask the advisory databases about every locked package"

setup: $(VENV)/ready
setup-dev: $(VENV)/ready-dev

$(VENV)/ready: pyproject.toml requirements/installer.txt requirements/build.txt \
		requirements/run.txt
	@$(PYTHON) scripts/set-up run
	@touch $@

$(VENV)/ready-dev: pyproject.toml requirements/installer.txt requirements/build.txt \
		requirements/dev.txt $(PEERS)/package-lock.json $(CLIENT)/package-lock.json
	@$(PYTHON) scripts/set-up dev
	@touch $@ $(VENV)/ready

demo: setup
	@$(BIN)/housefly demo

# What waits for clocks shares two cores with what computes; whole processes have them alone.
test: setup-dev
	$(call run_tests,3,'not realtime and not interop and not safety')
	$(call run_tests,1,'realtime and not interop and not safety',$(call marked,realtime))

interop: setup-dev $(TELLOPY)/ready $(CFLIB)/ready $(YAMSPY)/ready $(ROSLIBPY)/ready \
		$(HOME_ASSISTANT)/ready
	$(PYTEST) -n 2 -m 'interop and not realtime' $(call marked,interop)
	$(REALTIME) -m 'interop and realtime' $(call marked,interop)

# Compiled functions run as plain Python here: their branches count, too.
branches: setup-dev
	NUMBA_DISABLE_JIT=1 $(BIN)/coverage run -m pytest -q -n 0 --hypothesis-profile=same-examples \
		tests/pilot/safety
	$(BIN)/coverage report

# All of it is flown and written, whatever is found; what was found decides at the end. A folder
# that another source flew is refused, and an old page is not copied for a new one.
safety: setup-dev
	@$(BIN)/housefly safety --wires 1 --at-once 2 --out safety-case; flown=$$?; \
	[ $$flown -le 1 ] || exit $$flown; \
	cp safety-case/safety-case.html docs/safety-case.html && $(REALTIME) -m safety $(call marked,safety) && \
	$(MAKE) branches && exit $$flown

fuzz: setup-dev
	@$(BIN)/python -m pip install -q --disable-pip-version-check --require-hashes -r requirements/fuzz.txt
	$(BIN)/python tests/fuzz/run.py --seconds $(FUZZ_SECONDS)

test-fast: setup-dev
	$(PYTEST) -n 3 -m 'not wire and not browser and not slow and not safety'

check: setup-dev
	$(BIN)/ruff format --check $(CODE)
	$(BIN)/ruff check $(CODE)
	$(BIN)/mypy
	$(BIN)/mypy benchmarks scripts examples
	$(BIN)/lint-imports

format: setup-dev
	$(BIN)/ruff format $(CODE)
	$(BIN)/ruff check --fix $(CODE)

bench: setup-dev
	$(BIN)/python benchmarks/run.py

client: setup-dev
	npm run --silent --prefix $(CLIENT) build

$(TOOLS)/ready: requirements/tools.txt
	@$(PYTHON) -m venv $(TOOLS)
	@$(TOOLS)/bin/python -m pip install -q --require-hashes -r requirements/tools.txt
	@touch $@

$(TELLOPY)/ready: requirements/djitellopy.txt
	@$(PYTHON) -m venv $(TELLOPY)
	@$(TELLOPY)/bin/python -m pip install -q --require-hashes -r requirements/djitellopy.txt
	@touch $@

$(CFLIB)/ready: requirements/cflib.txt
	@$(PYTHON) -m venv $(CFLIB)
	@$(CFLIB)/bin/python -m pip install -q --require-hashes -r requirements/cflib.txt
	@touch $@

$(YAMSPY)/ready: requirements/yamspy.txt
	@$(PYTHON) -m venv $(YAMSPY)
	@$(YAMSPY)/bin/python -m pip install -q --require-hashes -r requirements/yamspy.txt
	@touch $@

$(ROSLIBPY)/ready: requirements/roslibpy.txt
	@$(PYTHON) -m venv $(ROSLIBPY)
	@$(ROSLIBPY)/bin/python -m pip install -q --require-hashes -r requirements/roslibpy.txt
	@touch $@

$(HOME_ASSISTANT)/ready: requirements/homeassistant.txt
	@$(PYTHON) -m venv $(HOME_ASSISTANT)
	@$(HOME_ASSISTANT)/bin/python -m pip install -q --require-hashes -r requirements/homeassistant.txt \
		|| echo "Home Assistant 2024.3.3 needs Python 3.11 or 3.12: its test is skipped"
	@touch $@

lock: $(TOOLS)/ready
	@scripts/lock $(TOOLS)/bin/uv

audit: $(TOOLS)/ready
	@scripts/audit $(TOOLS)/bin/pip-audit

clean:
	rm -rf $(VENV) $(PEERS)/node_modules $(CLIENT)/node_modules
