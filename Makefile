# `make render`: an image on a fresh machine. `make gallery`: the figures of scenes/thesis, scenes/groller, scenes/paths and scenes/spacetimes, with a page. `make manual`: the manual as a web site. `make test`: every check. `make python`: the Python package. `make fuzz`: a search for inputs that make a reader fail. `make release`: an archive of the program.

SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c

.PHONY: render gallery manual test python fuzz fuzz-lines fuzz-program release device tools clean

render: device
	cargo build --release
	mkdir -p out
	target/release/bentray render scenes/black_hole.toml -o out/black_hole.png
	@echo "open out/black_hole.png"

# Every command of the figures' own pages, and a page that shows them; `GALLERY` adds to each, such as `make gallery GALLERY="--size 100x100"`.
gallery: device
	cargo build --release
	cargo run -q --release --example gallery -- target/release/bentray out $(GALLERY)

# The manual as a web site: the example writes its source, mdBook makes the pages, and every link is checked.
manual:
	cargo build --bin bentray --example manual
	cargo run -q --example manual -- target/debug/bentray target/manual
	cargo run -q --manifest-path manual/site/Cargo.toml --target-dir target/site -- target/manual

# One more than there are processors: some tests wait, for a queue or for a child.
TESTS_AT_ONCE := $(shell echo $$(($$(getconf _NPROCESSORS_ONLN) + 1)))

# The last line counts the tests, after the messages of those that failed. A test that needs another program has the program's name at the
# end of its own, is ignored by a plain `cargo test`, and is skipped here only without that program.
test: device tools
	cargo fmt --all --check
	cargo clippy --workspace --all-targets -- -D warnings
	RUSTDOCFLAGS="-D warnings" cargo doc --no-deps
	mkdir -p target
	: >target/test.log
	status=0; skip=; export PATH="$$PATH:/usr/sbin"; \
	needs() { for program in "$${@:2}"; do \
	    command -v "$$program" >/dev/null || { echo "$$program is not installed: skipping tests $$1"; skip+=" --skip $$1"; return 0; }; \
	done; }; \
	target/python/bin/python -c 'import numpy, astropy, h5py, OpenEXR' 2>/dev/null || \
	    { python3 -m venv target/python && target/python/bin/pip install -q numpy astropy h5py OpenEXR; } || rm -rf target/python; \
	needs with_numpy target/python/bin/python; \
	needs with_ffmpeg ffmpeg; \
	needs with_parallel parallel; \
	needs with_slurm munged slurmctld slurmd sbatch squeue; \
	[ "$$(id -u)" -eq 0 ] || { echo "Slurm's daemons need root: skipping tests with_slurm"; skip+=" --skip with_slurm"; }; \
	run() { cargo test "$$@" 2>&1 | tee -a target/test.log || status=1; }; \
	run --lib; \
	run --doc; \
	run --test suite -- --test-threads $(TESTS_AT_ONCE) --include-ignored $$skip; \
	for example in picture custom_law rays_to_numbers; do cargo run -q --example $$example || status=1; done; \
	$(MAKE) --no-print-directory manual || status=1; \
	grep -A 3 'panicked at' target/test.log || true; \
	awk '/^test result:/ { passed += $$4; failed += $$6; skipped += $$8 + $$12 } \
	    END { printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped }' target/test.log; \
	exit $$status

# The Python package as a wheel in target/wheels, and its tests, in a virtual environment of their own.
PYTHON := target/python-wheel

python: device
	$(PYTHON)/bin/python -c "import maturin, numpy, matplotlib, pytest" 2>/dev/null || { python3 -m venv $(PYTHON) && $(PYTHON)/bin/pip install -q maturin numpy matplotlib pytest; }
	cargo build --release
	rm -rf target/wheels
	$(PYTHON)/bin/maturin build -q --release -m python/Cargo.toml --out target/wheels
	$(PYTHON)/bin/pip install -q --force-reinstall --no-deps target/wheels/*.whl
	BENTRAY=$$PWD/target/release/bentray $(PYTHON)/bin/pytest -q -p no:cacheprovider python/tests

# Searches for files that make a reader fail, for SECONDS_EACH seconds per reader of tests/fuzz, or for RUNS inputs. Failing inputs are
# saved in target/fuzz/found. READERS="obj ply" selects readers. It needs a C++ compiler.
SECONDS_EACH ?= 60
RUNS ?= -1
READERS ?= $(notdir $(wildcard tests/fuzz/corpus/*))

fuzz: fuzz-program
	status=0; for reader in $(READERS); do \
	    echo "== $$reader"; mkdir -p "target/fuzz/grown/$$reader"; \
	    READER=$$reader target/fuzz/fuzz -max_total_time=$(if $(filter -1,$(RUNS)),$(SECONDS_EACH),0) -runs=$(RUNS) -timeout=3 \
	        -rss_limit_mb=4096 -max_len=8192 -verbosity=0 -print_final_stats=1 "-artifact_prefix=target/fuzz/found/$$reader-" \
	        "target/fuzz/grown/$$reader" "tests/fuzz/corpus/$$reader" || status=1; \
	done; exit $$status

# Prints the fraction of each source file's lines that the inputs of the corpus and of `make fuzz` reach.
fuzz-lines: fuzz-program
	for reader in $(READERS); do \
	    echo "== $$reader"; mkdir -p "target/fuzz/grown/$$reader"; \
	    READER=$$reader target/fuzz/fuzz -runs=0 -max_len=8192 -print_full_coverage=1 "-artifact_prefix=target/fuzz/found/$$reader-" \
	        "target/fuzz/grown/$$reader" "tests/fuzz/corpus/$$reader" 2>&1 | \
	        awk '/^[UC] / { for (i = 2; i <= NF; i++) { line[$$i]; if ($$1 == "C") tried[$$i] } } \
            END { for (at in line) { split(at, file, ":"); all[file[1]]++; some[file[1]] += at in tried } \
                for (name in some) if (some[name] && name != "<null>") \
                    printf "%5.1f %% of %4d lines  %s\n", 100 * some[name] / all[name], all[name], name }' | sort -k6; \
	done

fuzz-program:
	cp Cargo.lock tests/fuzz/Cargo.lock
	mkdir -p target/fuzz/found
	host=$$(rustc -vV | sed -n 's/^host: //p'); cd tests/fuzz; \
	    RUSTFLAGS="-Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 -Cllvm-args=-sanitizer-coverage-inline-8bit-counters \
	    -Cllvm-args=-sanitizer-coverage-pc-table -Cllvm-args=-sanitizer-coverage-trace-compares --cfg fuzzing" \
	    cargo build --release --target "$$host" --target-dir ../../target/fuzz; \
	cp "../../target/fuzz/$$host/release/fuzz" ../../target/fuzz/fuzz

# The program with its manual pages and completions, as an archive to unpack in /usr/local or anywhere, and as a Debian package where
# cargo-deb is there to make one; with checksums, in target/dist.
release:
	cargo build --release --locked
	rm -rf target/dist
	mkdir -p target/dist/share/{man/man1,bash-completion/completions,fish/vendor_completions.d,zsh/site-functions}
	cd target/dist/share; program=../../release/bentray; \
	$$program completions bash >bash-completion/completions/bentray; \
	$$program completions fish >fish/vendor_completions.d/bentray.fish; \
	$$program completions zsh >zsh/site-functions/_bentray; \
	$$program man >man/man1/bentray.1; \
	for command in $$(sed -n 's/^bentray\\-\(.*\)(1)$$/\1/p' man/man1/bentray.1); do \
	    $$program man "$$command" >"man/man1/bentray-$$command.1"; \
	done
	name=bentray-$$(target/release/bentray --version | cut -d' ' -f2)-$$(rustc -vV | sed -n 's/^host: //p'); \
	mkdir -p "target/dist/$$name/bin"; \
	cp target/release/bentray "target/dist/$$name/bin"; \
	cp -r README.md LICENSE target/dist/share "target/dist/$$name"; \
	tar -C target/dist -czf "target/dist/$$name.tar.gz" "$$name"; \
	rm -r "target/dist/$$name"
	if cargo deb --version >/dev/null 2>&1; then cargo deb --no-build --locked --output target/dist/; \
	else echo "no Debian package was made: cargo-deb is missing, which \`cargo install cargo-deb\` brings" >&2; fi
	cd target/dist; sums="$$(command -v sha256sum || echo shasum -a 256)"; $$sums bentray* | tee sha256sums

# A Vulkan driver, a software one if there is none, and a linker. macOS and Windows bring their own, and were not tried.
device:
	@if [ "$$(uname -s)" != Linux ]; then exit 0; fi; \
	missing=(); \
	command -v cc >/dev/null || missing+=(gcc libc6-dev); \
	if [ -z "$${VK_DRIVER_FILES:-$${VK_ICD_FILENAMES:-}}" ] && \
	    ! compgen -G '/usr/share/vulkan/icd.d/*.json' >/dev/null && ! compgen -G '/etc/vulkan/icd.d/*.json' >/dev/null; \
	then missing+=(mesa-vulkan-drivers); fi; \
	ldconfig -p 2>/dev/null | grep -q 'libvulkan\.so\.1' || missing+=(libvulkan1); \
	if [ $${#missing[@]} -eq 0 ]; then exit 0; fi; \
	if ! command -v apt-get >/dev/null; then \
	    echo "please install: a C compiler, the Vulkan loader and a Vulkan driver" >&2; \
	    echo "  Fedora: gcc vulkan-loader mesa-vulkan-drivers; Arch: gcc vulkan-icd-loader vulkan-swrast" >&2; exit 1; fi; \
	root=; if [ "$$(id -u)" -ne 0 ]; then \
	    command -v sudo >/dev/null || { echo "please install, as root: $${missing[*]}" >&2; exit 1; }; root=sudo; fi; \
	echo "installing $${missing[*]}"; \
	$$root apt-get update -q; \
	DEBIAN_FRONTEND=noninteractive $$root apt-get install -q -y --no-install-recommends "$${missing[@]}"

# Programs that some tests need. They are installed only where that needs no password; `make test` skips tests whose program is missing.
tools:
	@if { command -v slurmctld && command -v parallel && command -v ffmpeg && python3 -c 'import ensurepip'; } >/dev/null 2>&1 || ! command -v apt-get >/dev/null || [ "$$(id -u)" -ne 0 ]; then exit 0; fi; \
	echo "installing Slurm, GNU parallel, ffmpeg and Python, for the tests"; \
	apt-get update -q >/dev/null 2>&1 || true; \
	DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends slurmctld slurmd slurm-client munge parallel ffmpeg python3-venv \
	    >/dev/null 2>&1 || true

clean:
	cargo clean
	rm -rf out
