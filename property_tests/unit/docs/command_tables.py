"""How commands of the docs are made short and concrete, and which are not run. One table for each question."""

import re

# What stands for something in capitals, in the order in which it is looked for.
PLACEHOLDERS = [
    (r"--(replay|from) FILE", r"--\1 out/check/findings.jsonl"), (r"replay FILE", "replay out/check/findings.jsonl"),
    (r"--(html|svg|png) FILE\b(?!\.)", r"--\1 file.\1"), (r"--heat FILE", "--heat file.png"),
    (r"\[FILE\]", "case.json"), (r"\[ARGUMENT…\]", ""), (r"\bFILE\.html\b", "page.html"), (r"\bFILE\b", "file.out"),
    (r"\b(SHAPE|TOPIC)/METHOD\b", "sphere/textbook"), (r"\bSCENE\.json\b", "docs/scenes/far-sphere.json"),
    (r"\bIMAGE(\.png)?\b", "image.png"), (r"\bCASE\b", "case.json"), (r"\bTOPIC\b", "sphere"), (r"\bDIR\b", "folder"),
    (r"--property NAME", "--property verdict"), (r"test -R NAME", "test -R docs/"), (r"\bN\b", "1"), (r"--shape disk", "--shape box")]
UNKNOWN = re.compile(r"(?<![\w=$'\"-])(?:[A-Z]{2,}|[A-Z])(?![\w=])")  # in capitals still: no value of ours

# Numbers that are set in a command whatever it has, and options that are added where it has none of a kind.
SMALLER = [(r"rayproof check\b(?!.*--replay\b)", "--cases", "200"), (r"rayproof worst\b", "--cases", "500"), (r"rayproof spawn\b", "--cases", "32"), (r"--cases 400000", "--cases", "20"), (r"rayproof report\b(?!.*--figures\b)", "--rays", "256"), (r"rayproof report\b(?!.*--figures\b)", "--time", "0.02"),
           (r"rayproof bench\b", "--benchmark_min_time", "0.001"),
           (r"rayproof render\b(?!.*--case\b)", "--size", "240x135"), (r"rayproof leak\b", "--rays", "5000")]
ADDED = [(r"rayproof check\b(?!.*--(shape|topic|method|replay)\b)", "--topic quadratic"),
         (r"rayproof spawn\b(?!.*--strategy\b)", "--strategy proven"),  # the others' smallest cases take seconds to find
         (r"rayproof report\b(?!.*--(figures|scaling|shape|topic)\b)", "--shape quadratic"),
         (r"rayproof report\b(?!.*--(figures|scaling|family)\b)", "--family random"),
         (r"rayproof report\b(?!.*--(figures|scaling|precision)\b)", "--precision float32")]
# A check of all methods; a test of the whole check runs one.
ANY_CHECK = re.compile(r"(?:\./)?rayproof check")
# What does the same on every page, so that no later command of the page needs it: run for the first page that has it.
SAME_EVERYWHERE = re.compile(r"(?:\./)?rayproof (?:spawn|worst|report|methods|cases|leak --rays \d+$|test|lab list|walk --list|"
                             r"walk \S+ --html \S+$|check --cases 200 --topic quadratic$)")

# Needs no picture by VTK: pages/ and viz/ test those.
WRITES_PAGES = re.compile(r"rayproof walk (?!.*--(?:png|movie|window))")

# Commands that would take long: the same command on less, with its output compared but for the numbers.
SHORTER = [(r"(rayproof worst.*) --time \w+", r"\1"), (r"walk all --png", "walk ray --png"),
           (r"walk (spheres|sphere|far-sphere) --png", r"walk \1 --html"),  # a slide takes a second: those of one topic are drawn
           (r"lab grade class", "lab grade class --seconds 300"),  # a busy machine compiles for longer than ten
           (r"RAYPROOF_QUADRIC_RAYS=\d+", "RAYPROOF_QUADRIC_RAYS=2000"),
           (r"run\.py --build \S+", "run.py --list --build {build}"), (r"^(cmake --preset \S+) .*", r"\1 -N"),
           (r"^cmake --build build/mutation --target (\S+)$", r"cmake --build {build} --target help | grep -E '(^| )\1(:|$)'"),
           (r"^ctest ", "ctest --test-dir {build} --show-only "), (r"build/release/bin/", "{bin}/"),
           (r"^RAYPROOF_SURFACES_PICTURE=.*", r"\g<0> --gtest_list_tests")]

# In the sources themselves, since they change nothing there.
IN_THE_SOURCE = r"^(cmake|ctest|python3 property_tests)"

# Not 0, and what is said then.
ENDS_WITH = [(r"python-raytracer/answer\.py", 1, ""), (r"walk .*--window", 2, "isplay"), (r"lab check \w", 1, "")]

# Not run: why, and the file that must hold what is run in its place.
NOT_RUN = [
    (r"^apt-get ", "changes the machine; .ci/run and ./rayproof install from the same list", "cmake/debian-packages.txt", "libglm-dev"),
    (r"^cmake (-S \. -B build|--(build|install) build(/library|$))", "install/ runs README's recipe",
     "property_tests/unit/install/tests.cmake", "the_readmes_commands_build_and_install_the_library"),
    (r"^build/my_tracer", "install/ runs README's recipe", "property_tests/unit/install/tests.cmake",
     "the_readmes_project_prints_what_the_readme_says"),
    (r"^cmake --(build|install) build/laboratory|build/my_property", "install/ runs the page's recipe",
     "property_tests/unit/install/tests.cmake", "a_property_of_twenty_lines_finds_a_case_of_three_digits"),
    (r"^cmake (-S examples/|--build build/(batch|suite)$)|build/(batch/batch|suite/my_suite)$", "install/ runs the page's commands",
     "property_tests/unit/install/tests.cmake", "a_googletest_suite_of_twenty_lines_finds_the_mistake"),
    (r"^g\+\+ .* main\.cpp", "install/ runs the manual's command", "property_tests/unit/install/library/claims.py", '"Without CMake"'),
    (r"^g\+\+ .* my_sphere\.cpp|--subject-command \./my_sphere", "own_code.py follows the page",
     "property_tests/unit/docs/own_code.py", "your-own-code.md"),
    (r"rayproof (findings|bugreport)\b", "needs the libraries; reports are made and their programs run where they are built",
     "property_tests/unit/peers/reproductions.py", "rayproof-bugreport"),
    (r"check --subject [a-z]", "needs the libraries; each is asked where it is built", "property_tests/unit/peers/easy.py",
     "registry.txt"),
    (r"lab grade /autograder|^cp \S+ /autograder/", "needs Gradescope's container; a test writes and reads its results", "property_tests/unit/labs/grade.py",
     "--gradescope"),
    (r"^(parallel|nice -n 10 \./rayproof check --campaign|\./rayproof (check --campaign|merge)|rayproof merge|rayproof check --campaign)", "needs many cases; tests run shards, merge and GNU parallel",
     "property_tests/unit/programs/campaign_test.cpp", "GnuParallel"),
    (r"rayproof leak \S+ .*--subject ", "needs the libraries; each is asked where it is built", "property_tests/unit/peers/easy.py",
     "registry.txt"),
    (r"property_tests/builds --bin", "takes an hour; a test compares two builds", "property_tests/unit/CMakeLists.txt",
     "a_target_with_flags_of_its_own_gets_the_same_bits"),
    (r"rayproof walk \S+ --movie", "takes half a minute; a test writes and reads a short film", "property_tests/unit/vtk/movie_test.cpp",
     "IsAnOggFileWithATheoraHeader"),
    (r"rayproof leak (MESH\.off|\[MESH\])", "needs a mesh; a test reads one in each format",
     "property_tests/unit/leaks/mesh_test.cpp", "IsTheSameInEveryFormat"),
    (r"^python3 \S+/labs/grade\.py", "takes minutes; a test grades a folder of each kind", "property_tests/unit/CMakeLists.txt",
     "hundreds_are_graded_and_none_spoils_anothers"),
    (r"^doxygen docs/Doxyfile", "takes long; .ci/run runs it", ".ci/run", "Doxyfile"),
    (r"rayproof docs\b", "takes a minute and packages of its own; .ci/run runs it", ".ci/run", "./rayproof docs"),
    (r"^python3 \S+/add_a_shape/prove\.py", "takes minutes; .ci/run runs it", ".ci/run", "add_a_shape/prove.py"),
    (r"^python3 docs/figures\.py", "needs half an hour of measuring; a test has it write made-up figures",
     "property_tests/unit/CMakeLists.txt", "tables_of_speed_are_written_from_what_was_measured"),
    (r"^python3 docs/errata\.py", "takes minutes; its page is compared case by case instead", "docs/errata.py", "in_words")]

# Blocks that are no command and no output of one, and the file that compares them.
HELD_ELSEWHERE = [("…", "property_tests/unit/docs/own_code.py"),
                  ("this method answers no batches", "property_tests/unit/install/library/refusals.py"),
                  ("rayproof needs NaN, infinity and exact rounding", "property_tests/unit/install/library/refusals.py")]

# What a build or a machine may lack; said on standard error.
LACKING = re.compile(r"needs VTK|no virtual display|Xvfb|does not have|instruction set")
