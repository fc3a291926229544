# make demo   set up .venv, run the main job, say where its pictures are
# make test   set up .venv, run the tests
# make test-page  try the lab's page in a browser; test-page-fast: what of it is quick
# make test-fast  run the unit tests and closed forms that take less than about a second each, and the command lines
# make test-kernels  run what leans on linear algebra with another kernel of OpenBLAS than the processor's own
# make lint   ruff, clang-format, pyright, import-linter
# make docs   the site, in build/docs: everything is made here, nothing is fetched
# make docs-text  the same but for the gallery's pictures, in seconds
# make bench  the speed report
# make bench-peers  the same sheets through MuJoCo's batch and through ours
# make fuzz   thousands of random scenarios and commands: none may crash, hang or answer with nonsense
# make sanitize   the engine's tests and random scenarios on a core that reports every wrong access
# make lab    build the page of `plategait lab`: the core for a browser, the page's modules (needs node)
# make lab-check  build it anew elsewhere: what is shipped must be the same, byte by byte

PYTHON ?= python3
BIN := .venv/bin
# A process for each of up to four cores; files stay whole, as some share what took long to make. One thread of BLAS in
# each: more would wait for one another. In the order of their folders: by default files of few tests, which are those of
# long ones, come last, and one process waits for the other.
PYTEST := OPENBLAS_NUM_THREADS=1 $(BIN)/python -m pytest -n auto --maxprocesses 4 --dist loadfile --no-loadscope-reorder
SOURCES := pyproject.toml CMakeLists.txt $(wildcard native/*)

# Compiled modules are kept, whatever the environment says: each command that a test starts would compile all anew.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo test test-page test-page-fast test-fast test-kernels lint docs docs-text bench bench-peers fuzz sanitize lab lab-check clean always

$(BIN)/python:
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "plategait needs Python 3.11 or newer: make PYTHON=python3.12")'
	$(PYTHON) -m venv .venv

# An editable install knows the modules that there were: it is made anew when one comes or goes.
.venv/modules: $(BIN)/python always
	@find src -name '*.py' | LC_ALL=C sort | cmp -s - $@ || find src -name '*.py' | LC_ALL=C sort > $@

.venv/installed: $(SOURCES) .venv/modules
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --editable .
	touch $@

# What is installed satisfies pip, which adds what the extra asks for and builds nothing again.
.venv/installed-test: .venv/installed
	$(BIN)/python -m pip install --quiet --disable-pip-version-check 'plategait[test]'
	touch $@

.venv/installed-lint: .venv/installed
	$(BIN)/python -m pip install --quiet --disable-pip-version-check 'plategait[lint]'
	touch $@

demo: .venv/installed
	$(BIN)/python examples/demo.py

test: .venv/installed-test
	$(PYTEST) -m "not browser"

# The lab's page in a browser, which draws three dimensions on the processor: minutes.
test-page: .venv/installed-test
	$(PYTEST) -m browser

test-page-fast: .venv/installed-test
	$(PYTEST) -m "browser and not slow"

# The inner loop: without films, campaigns of processes, and comparisons with other engines and with what is published.
test-fast: .venv/installed-test
	$(PYTEST) -m "not slow and not browser" tests/unit tests/analytical tests/end_to_end/test_command_lines.py

# Any x86-64 processor has Prescott's instructions, and hardly any in use chooses its kernel by itself.
test-kernels: .venv/installed-test
	OPENBLAS_CORETYPE=$(if $(filter Prescott,$(OPENBLAS_CORETYPE)),Haswell,Prescott) $(PYTEST) -m linear_algebra

lint: .venv/installed-lint
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/clang-format --dry-run --Werror native/*
	$(BIN)/pyright --threads 2
	$(BIN)/lint-imports

.venv/installed-docs: .venv/installed
	$(BIN)/python -m pip install --quiet --disable-pip-version-check 'plategait[docs]'
	touch $@

# A warning is an error: a page in no list, a link to nothing, an example that fails, a page that would fetch something.
docs: .venv/installed-docs
	OPENBLAS_NUM_THREADS=1 $(BIN)/sphinx-build -q -W --keep-going -b html -d build/doctrees docs build/docs
	@echo build/docs/index.html

# The same but for the gallery's pictures, whose examples are tests.
docs-text: .venv/installed-docs
	OPENBLAS_NUM_THREADS=1 $(BIN)/sphinx-build -q -W --keep-going -D plot_gallery=0 -b html \
	  -d build/doctrees-text docs build/docs-text

bench: .venv/installed-test
	$(BIN)/python -m benchmarks

.venv/installed-peers: .venv/installed
	$(BIN)/python -m pip install --quiet --disable-pip-version-check 'plategait[peers]'
	touch $@

bench-peers: .venv/installed-peers
	$(BIN)/python -m benchmarks.peers

fuzz: .venv/installed
	$(BIN)/python -m benchmarks.fuzz --scenarios 12000 --commands 500 --edges 1000 --seed 1

# An environment of its own for the core with gcc's sanitizers, which borrows what .venv has installed. The sanitizers'
# library must be loaded before Python; without leak checks, as an interpreter never frees all.
SANITIZED := build/sanitize
SANITIZERS = env LD_PRELOAD="$$(gcc -print-file-name=libasan.so) $$(gcc -print-file-name=libstdc++.so)" \
	ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1
ENGINE_TESTS := tests/agreement/test_same_bits.py tests/unit/test_native.py tests/unit/test_engine.py \
	tests/analytical/test_single_node.py tests/analytical/test_on_the_plate.py tests/analytical/test_joints.py

$(SANITIZED)/installed: $(SOURCES) .venv/installed-test
	$(BIN)/python -m venv --clear $(SANITIZED)
	$(BIN)/python -c 'import sysconfig; print(sysconfig.get_path("purelib"))' \
	  > $$($(SANITIZED)/bin/python -c 'import sysconfig; print(sysconfig.get_path("purelib"))')/borrowed.pth
	$(SANITIZED)/bin/python -m pip install --quiet --disable-pip-version-check --no-deps \
	  -C build-dir=build/sanitize-core -C cmake.define.PLATEGAIT_SANITIZE=ON --editable .
	touch $@

sanitize: $(SANITIZED)/installed
	$(SANITIZERS) $(SANITIZED)/bin/python -m pytest $(ENGINE_TESTS)
	$(SANITIZERS) $(SANITIZED)/bin/python -m benchmarks.fuzz --scenarios 500 --commands 0 --edges 50 --seed 2 --memory 0 --limit 300

# The page is shipped as it is built here, so that nobody else needs the compiler, node or a browser. The compiler comes
# from a package, its version from lab/build_engine.py, that of everything else from lab/package-lock.json.
SHIPPED := src/plategait/lab/shipped
ZIG := build/lab/zig

$(ZIG)/installed: lab/build_engine.py
	$(PYTHON) -m venv --clear $(ZIG)
	$(ZIG)/bin/python -m pip install --quiet --disable-pip-version-check \
	  ziglang==$$(sed -n 's/^COMPILER = "\(.*\)"/\1/p' $<)
	touch $@

lab/node_modules/.package-lock.json: lab/package-lock.json
	cd lab && npm ci --no-audit --no-fund --silent

# Into a folder of its own, with a cache of the compiler beside it that was empty.
BUILD_LAB = rm -rf $(1) $(1)-cache && mkdir -p $(1) \
	&& ZIG_GLOBAL_CACHE_DIR=$(abspath $(1)-cache) $(ZIG)/bin/python lab/build_engine.py $(1)/engine.wasm \
	&& npm run --silent --prefix lab build -- $(abspath $(1)) && $(ZIG)/bin/python lab/built_from.py write $(1)

lab: $(ZIG)/installed lab/node_modules/.package-lock.json
	$(call BUILD_LAB,build/lab/made)
	rm -rf $(SHIPPED) && mv build/lab/made $(SHIPPED)

lab-check: $(ZIG)/installed lab/node_modules/.package-lock.json
	$(call BUILD_LAB,build/lab/check)
	diff -r --brief build/lab/check $(SHIPPED)

clean:
	rm -rf .venv build out lab/node_modules docs/gallery
