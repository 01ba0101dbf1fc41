# Two commands: `make demo` renders a first picture, `make test` runs all tests. They prepare everything they need.
.DEFAULT_GOAL := help
.PHONY: help build quick demo test editor check parity bench clean rust povray chromium
SHELL := /bin/bash

# The first that runs and is new enough: a name on the PATH may be a version manager's shim for a Python that is not there.
PYTHON ?= $(shell for p in python3.13 python3.12 python3.11 python3; do \
  $$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' >/dev/null 2>&1 && { echo $$p; break; }; done)
VENV := .venv
BIN := $(VENV)/bin
CARGO := $(shell command -v cargo 2>/dev/null || echo $(HOME)/.cargo/bin/cargo)
export PATH := $(dir $(CARGO)):$(PATH)
RUST_SOURCES := $(shell find tracer/src -name '*.rs') tracer/Cargo.toml tracer/Cargo.lock
SCENES ?= *
THREADS ?= 2

help: ## list the targets
	@grep -hE '^[a-z]+:.*## ' $(MAKEFILE_LIST) | sed 's/:.*## /\t/' | expand -t 10

# The package with its dependencies; rebuilt when a Rust source or pyproject.toml changes.
build: $(VENV)/installed ## build the package into .venv
$(VENV)/installed: pyproject.toml $(RUST_SOURCES) | $(BIN)/python rust
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[test,check]'
	@touch $@

quick: ## rebuild only the core, incrementally, into an environment that `make build` made
	$(CARGO) build --quiet --profile quick --features python --manifest-path tracer/Cargo.toml
	@$(BIN)/python -c 'import sysconfig; print("tracer/_core" + sysconfig.get_config_var("EXT_SUFFIX"))' | \
	  { read -r core; cp tracer/target/quick/libminipov_tracer.so "$$core.new" && mv "$$core.new" "$$core"; }

$(BIN)/python:
	@test -n "$(PYTHON)" && "$(PYTHON)" -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "minipov needs Python 3.11 or newer (make PYTHON=/path/to/python3.11)"; exit 1; }
	@"$(PYTHON)" -m venv $(VENV) || { echo "python3-venv is missing: apt-get install python3-venv"; exit 1; }

rust:
	@command -v "$(CARGO)" >/dev/null || \
	  { echo "minipov's tracer is compiled by Rust, which is missing: see https://rustup.rs, then run make again"; exit 1; }

demo: build ## render scenes/gallery/demo.pov and say where the picture is
	@mkdir -p out
	@$(BIN)/minipov scenes/gallery/demo.pov -o out/demo.png -W 640 -H 480 --antialias-threshold=0.1
	@echo "The picture is out/demo.png"

povray:
	@tools/install-povray

chromium:
	@tools/install-chromium

test: build povray chromium ## run cargo test and pytest (installs POV-Ray and Chromium, which they need)
	$(CARGO) test --quiet --manifest-path tracer/Cargo.toml
	$(BIN)/python -m pytest -q -n 2
	@if command -v npm >/dev/null; then $(MAKE) --no-print-directory editor; \
	  else echo "Node.js is missing: the VS Code extension was not tested"; fi

editor: ## test the VS Code extension and pack it (needs Node.js)
	cd editor/vscode && npm ci --silent && npm test --silent && npm run --silent package
	@echo "The extension is editor/vscode/out/minipov.vsix"

# mypy sees the five rooms as one package through links, as an installation does.
MYPY_TREE := build/mypy
$(MYPY_TREE)/minipov: $(shell find minipov grammar interpreter tracer editor -name __init__.py -not -path "*/target/*" -not -path "*/node_modules/*")
	@tools/link-package $(MYPY_TREE)

check: build $(MYPY_TREE)/minipov ## ruff, mypy --strict, clippy, rustfmt
	$(BIN)/python -m ruff check .
	$(BIN)/python -m ruff format --check .
	MYPYPATH=$(MYPY_TREE) $(BIN)/python -m mypy --strict -p minipov
	MYPYPATH=$(MYPY_TREE):tests/tools $(BIN)/python -m mypy --strict tests/api tests/cli tests/docs tests/parity tests/tools
	$(CARGO) clippy --quiet --manifest-path tracer/Cargo.toml --all-targets -- -D warnings
	$(CARGO) clippy --quiet --manifest-path tracer/Cargo.toml --features python --lib -- -D warnings
	$(CARGO) fmt --manifest-path tracer/Cargo.toml -- --check

parity: build povray ## compare with POV-Ray on its own samples (SCENES=glob)
	$(BIN)/python -m minipov diff /usr/share/doc/povray/examples --only "$(SCENES)" --page out/parity --jobs 2

bench: build povray ## trace times against POV-Ray (THREADS=n)
	$(BIN)/python -m minipov.bench --threads $(THREADS)

clean: ## remove what was built
	rm -rf $(VENV) build out minipov.egg-info tracer/target tracer/*.so
