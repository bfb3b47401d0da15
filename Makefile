# make demo   the main job: an exam for the demonstration class, marked
# make practice   the practice sheet of the demonstration bank
# make test   the tools that tests need (make tools), lint, types, tests
# make demo-answers   after a change of templates or banks/demo.toml: what the demonstration class types
# make fairness   students who work rightly, or make each known mistake, on 1,000 papers of every template (20 minutes)
# make docs   this program's pages for people, as a site in build/docs
# make picture   the page that README shows, printed again (poppler)
# make costs   the picture of what papers and answers cost by the size of the class, measured anew (an hour)
# make measure   how large and how dense the code is, beside what its rebuilding aims at
# make prove   every proof at new seeds, as many as its share of an hour allows on two cores
# make catalogue LANGUAGE=de   the words of a language brought up to the English ones, or begun
# make tools  what tests and benchmarks need besides Python: LaTeX with siunitx, poppler (Debian and Ubuntu;
#             elsewhere it says what to install)
# They set themselves up in .venv on a machine with Python 3.11 or newer and pip.

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
# Modules are kept compiled, as those of an installed program are
unexport PYTHONDONTWRITEBYTECODE
READY := $(VENV)/.ready

.PHONY: docs picture costs demo practice demo-answers test lint types bench measure fairness prove catalogue golden check-templates tools clean

$(READY): pyproject.toml
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade "pip>=25.1"
	$(BIN)/python -m pip install --quiet --editable . --group dev
	touch $(READY)

demo: $(READY)
	mkdir -p demo
	$(BIN)/kinegrade generate banks/demo.toml banks/demo-roster.csv -o demo/EXAM --reproducible demo --solutions --force --new-numbers
	$(BIN)/kinegrade grade demo/EXAM banks/demo-answers.csv -o demo/MARKS --force || test $$? -eq 1
	@echo "papers: demo/EXAM/papers.pdf   key: demo/EXAM/key.pdf   marks: demo/MARKS/grades.csv   Moodle: demo/MARKS/moodle.csv"

practice: $(READY)
	mkdir -p demo
	$(BIN)/kinegrade practice banks/demo.toml -o demo/practice.html --force

demo-answers: $(READY)
	mkdir -p demo
	$(BIN)/kinegrade generate banks/demo.toml banks/demo-roster.csv -o demo/EXAM --reproducible demo --force --new-numbers
	$(BIN)/python -m tests.demo.type_answers demo/EXAM banks/demo-answers.csv

test: tools lint types $(READY)
	$(BIN)/python -m pytest -n auto --dist loadgroup --no-loadscope-reorder

lint: $(READY)
	$(BIN)/ruff format --check --quiet .
	$(BIN)/ruff check .

types: $(READY)
	$(BIN)/mypy

check-templates: $(READY)
	$(BIN)/kinegrade check --sample 5000

bench: $(READY)
	$(BIN)/python -m benchmarks

measure: $(READY)
	$(BIN)/python -m benchmarks.measures

fairness: $(READY)
	$(BIN)/python -m benchmarks.fairness

prove: $(READY)
	$(BIN)/python -m tests.prove

docs: $(READY)
	$(BIN)/python -m pip install --quiet --group docs
	$(BIN)/sphinx-build --quiet --fail-on-warning --keep-going docs build/docs
	@echo "docs: build/docs/index.html"

picture: $(READY)
	rm -rf build/picture
	mkdir -p build/picture
	printf 'student,name\n0012,Ada Byron\n' > build/picture/roster.csv
	$(BIN)/kinegrade generate demo build/picture/roster.csv -o build/picture/EXAM --reproducible picture
	pdftoppm -singlefile -r 80 -gray -png build/picture/EXAM/papers.pdf docs/pictures/paper

costs: $(READY)
	$(BIN)/python -m benchmarks.class_plot docs/pictures/class-costs.svg

catalogue: $(READY)
	$(BIN)/python -m tests.language.update $(LANGUAGE)

golden: $(READY)
	$(BIN)/python -m pytest -n 0 tests --regenerate-golden

tools:
	@$(PYTHON) -m tests.tools

clean:
	rm -rf $(VENV) demo .pytest_cache .mypy_cache .ruff_cache
