"""The page in a browser, as those who use it find its parts; its numbers beside those of the host, to the bit."""

import json
import math
import os
import random
import subprocess
from pathlib import Path

import pytest
from playwright.sync_api import sync_playwright

ROOT = Path(__file__).resolve().parents[3]
PAGE = Path(os.environ.get("RAYLET_PAGE", ROOT / "docs" / "try" / "index.html"))
SOLIDS = ["sphere", "cylinder", "open cylinder", "cone", "double cone", "frustum", "capsule", "box"]
NUMBERS = ["f32", "I16F16", "f64"]
DONE = "!document.querySelector('[aria-busy]')"


@pytest.fixture(scope="session")
def browser():
    """A browser without a window."""
    with sync_playwright() as playwright:
        chromium = os.environ.get("CHROMIUM", "/usr/bin/chromium")
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture
def opened(browser):
    """Opens the page from its file; afterwards nothing has failed, and nothing else was asked for."""
    pages, faults, asked = [], [], []

    def open_page(link="", **options):
        page = browser.new_context(**options).new_page()
        pages.append(page)
        page.set_default_timeout(60_000)
        page.on("pageerror", lambda error: faults.append(str(error)))
        page.on("console", lambda message: message.type == "error" and faults.append(message.text))
        page.on("request", lambda request: asked.append(request.url))
        page.goto(PAGE.as_uri() + link)
        page.wait_for_selector("body[data-ready]")
        return page

    yield open_page
    for page in pages:
        page.context.close()
    assert not faults
    assert all(url.split("#")[0] == PAGE.as_uri() for url in asked)


def crossings(page):
    """The rows of the table of crossings."""
    table = page.get_by_role("table", name="Crossings")
    return [row.get_by_role("cell").all_inner_texts() for row in table.get_by_role("row").all()[1:]]


def test_it_is_small():
    assert PAGE.stat().st_size <= 400_000


def test_a_solid_is_chosen(opened):
    page = opened()
    assert page.get_by_role("heading", level=1).count() == 1
    before = crossings(page)
    assert len(before) == 2
    page.get_by_role("combobox", name="Solid", exact=True).select_option("sphere")
    page.wait_for_function("document.querySelector('#sizes').textContent.trim() === 'radius'")
    after = crossings(page)
    assert after != before
    assert after[0][2:4] == ["enters", "side"] and after[1][2] == "exits"
    assert page.get_by_label("Tier").input_value() == "Stable"
    page.get_by_role("combobox", name="Number type", exact=True).select_option("f64")
    page.wait_for_function("location.hash.includes('number=f64')")
    assert page.get_by_label("Tier").locator("option").all_inner_texts() == ["Plain", "Fast", "Stable"]


def test_an_end_of_the_ray_is_dragged(opened):
    page = opened()
    before = crossings(page)
    box = page.get_by_role("button", name="Start of the ray").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 15, y + 40, steps=4)
    # Nothing is read out for each step of it.
    assert page.locator("#said").get_attribute("aria-busy") == "true"
    page.mouse.up()
    assert page.locator("#said").get_attribute("aria-busy") == "false"
    page.wait_for_function("location.hash.includes('start=')")
    assert crossings(page) != before
    # What is shown is what the host says of the same numbers.
    state = page.evaluate("({ ...state, origin: originOf(state), direction: minus(state.target, state.start) })")
    solid = {"solid": SOLIDS.index(state["solid"]), **{key: state[key] for key in ("sizes", "base", "axis")}}
    [answer] = host([{"number": 0, "solids": [solid], "rays": [[state["origin"], state["direction"]]]}])
    # A nine for each hit, of tier Stable: t is the first.
    shown = [float(row[0]) for row in crossings(page)]
    assert shown == answer["hits"][2][0][::9]


def test_keys_move_what_is_dragged(opened):
    page = opened()
    page.get_by_role("button", name="Base of the solid").focus()
    before = page.evaluate("state.base")
    page.keyboard.press("ArrowUp")
    page.wait_for_function("location.hash.includes('base=')")
    after = page.evaluate("state.base")
    assert after[1] > before[1]
    page.get_by_role("group", name="Picture").focus()
    page.keyboard.press("Shift+ArrowLeft")
    page.wait_for_function("location.hash.includes('turned=30.4')")
    page.get_by_role("slider", name="Start moved back").focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_function("location.hash.includes('back=1')")


def test_every_state_is_a_link(opened):
    page = opened()
    page.get_by_role("combobox", name="Example").select_option("along the side of a cone")
    page.get_by_role("combobox", name="Number type", exact=True).select_option("I16F16")
    page.get_by_role("combobox", name="Scene", exact=True).select_option("telescope")
    page.wait_for_function("location.hash.includes('scene=telescope') && location.hash.includes('number=I16F16')")
    again = opened("#" + page.url.split("#")[1])
    assert again.evaluate("state") == page.evaluate("state")
    assert crossings(again) == crossings(page)
    assert again.get_by_role("combobox", name="Scene", exact=True).input_value() == "telescope"


def test_every_example_answers(opened):
    page = opened()
    first, *names = page.get_by_role("combobox", name="Example").locator("option").all_inner_texts()
    assert first == "none, your own" and len(names) >= 5
    for name in names:
        page.get_by_role("combobox", name="Example").select_option(name)
        for number in NUMBERS:
            page.get_by_role("combobox", name="Number type", exact=True).select_option(number)
            page.wait_for_function(f"document.querySelector('#said').textContent.includes('in {number},')")
            said = page.locator("#said").inner_text()
            assert "crossing" in said and int(said.split("exactly ")[1][:-1]) > 0, (name, number, said)


@pytest.mark.parametrize("link", [
    "#solid=nothing&sizes=1,2&start=x,y,z&back=&tier=Best", "#%E0%A4%A", "#f64", "#back=400", "#back=2.5",
    "#sizes=1,,2",
])
def test_a_link_that_means_nothing_is_the_first_state(opened, link):
    page = opened(link)
    assert len(crossings(page)) == 2
    assert page.evaluate("String(Object.values(state)) === String(Object.values(INITIAL))")


def test_the_library_says_what_is_refused(opened):
    page = opened()
    page.get_by_role("spinbutton", name="radius").fill("-1")
    page.get_by_role("spinbutton", name="radius").press("Enter")
    page.wait_for_function("document.querySelector('#said').textContent.includes('radius')")
    assert "f32: the radius" in page.locator("#said").inner_text()
    page.wait_for_function(DONE)
    assert "f64: the radius" in page.locator("#measured").inner_text()
    assert not page.get_by_role("table", name="Error and time").get_by_role("cell").all()
    page.get_by_role("spinbutton", name="radius").fill("0.5")
    page.get_by_role("spinbutton", name="radius").press("Enter")
    page.wait_for_function("document.querySelector('#said').textContent.includes('exactly 2')")


def test_error_and_cost(opened):
    page = opened("#solid=sphere&sizes=1,0,0&base=0,0,0&start=-3,0.99,0&target=0,0.99,0&back=3")
    page.wait_for_function(DONE)
    rows = page.get_by_role("table", name="Error and time").get_by_role("row").all()[1:]
    told = {row.get_by_role("rowheader").inner_text(): row.get_by_role("cell").all_inner_texts() for row in rows}
    assert len(told) == 11
    assert told["f32 Exact"][1] == told["I16F16 Exact"][1] == "0"
    assert float(told["f32 Plain"][0]) > float(told["f32 Exact"][0]) > float(told["f64 Stable"][0]) > 0
    assert all(float(cells[2]) > 0 for cells in told.values())
    plot = page.get_by_role("img", name="Error against time")
    assert plot.locator("path").count() == 11


@pytest.mark.parametrize("scene", ["sea", "jetty", "telescope"])
def test_scenes(opened, scene):
    page = opened(f"#scene={scene}")
    page.wait_for_function(DONE)
    figures = page.get_by_role("figure").all()
    assert len(figures) == 4
    worst = [float(figure.inner_text().split()[-1]) for figure in figures]
    assert worst[0] > worst[2] >= worst[3] > 0
    assert ": 0 pixels" in figures[3].inner_text()
    for figure in figures:
        images = figure.get_by_role("img").all()
        colors = [image.evaluate("c => new Set(c.getContext('2d').getImageData(0, 0, 120, 90).data).size")
                  for image in images]
        assert len(colors) == 2 and colors[0] > 20


def test_on_a_phone(opened):
    page = opened("#type=f64", viewport={"width": 360, "height": 740}, has_touch=True, is_mobile=True)
    page.wait_for_function(DONE)
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    page.get_by_role("combobox", name="Solid", exact=True).select_option("capsule")
    page.wait_for_function("location.hash.includes('capsule')")


def test_dark_and_light(opened):
    color = "getComputedStyle(document.body).backgroundColor"
    dark, light = [opened(color_scheme=scheme).evaluate(color) for scheme in ("dark", "light")]
    assert light == "rgb(255, 255, 255)" and dark != light


# The numbers.

def host(worlds):
    """What the host says of these worlds."""
    program = ["cargo", "run", "--quiet", "--profile", "test", "--package", "raylet-page", "--example", "host"]
    lines = "".join(json.dumps(world) + "\n" for world in worlds)
    ran = subprocess.run(program, input=lines, capture_output=True, text=True, check=False, cwd=ROOT)
    assert ran.returncode == 0, ran.stderr
    return [json.loads(line) for line in ran.stdout.splitlines()]


IN_PAGE = """(request) => {
    try {
        const solids = request.solids.map(({ solid, ...rest }) => ({ name: Object.keys(SOLIDS)[solid], ...rest }));
        const world = library.world(NUMBERS[request.number], solids), tiers = tiersOf(NUMBERS[request.number]);
        for (const [origin, direction] of request.rays) world.aim(origin, direction);
        const flat = ({ t, part, crossing, point, normal }) => [t, part, crossing, ...point, ...normal];
        const hits = tiers.map((tier) => request.rays.map((_, i) => world.hits(tier, 0, i).flatMap(flat)));
        let rows = [];
        if (request.view) {
            world.look(request.view, [request.view.columns, request.view.rows]);
            const shown = Array.from({ length: Math.ceil(request.view.rows / 9) }, (_, i) => 9 * i);
            rows = tiers.map((tier) => shown.map((y) => [...world.row(tier, y)]));
        }
        const exact = request.rays.map((_, i) => exactCrossings(world.solid(0), world.ray(i)));
        const told = exact.map((list) => list.map(({ x, exponent, crossing }) => [toFloat(x, exponent), crossing]));
        return { hits, rows, exact: told };
    } catch (error) {
        return { refused: error.message };
    }
}"""


def random_world(number, draw):
    """A solid and rays: a half anywhere, a half on a coarse grid, where rays meet rims, edges and apexes."""
    on_grid = draw.random() < 0.5

    def coordinate(most):
        return draw.randint(-2 * int(most), 2 * int(most)) / 2 if on_grid else draw.uniform(-most, most)

    def point(most):
        return [coordinate(most) for _ in range(3)]

    sizes = [draw.choice([0.5, 1, 1.5]) if on_grid else draw.uniform(0.2, 2) for _ in range(3)]
    axis = draw.choice([[0, 1, 0], [1, 0, 0], [0, 0, -1]]) if on_grid else point(1)
    solid = {"solid": draw.randrange(len(SOLIDS)), "sizes": sizes, "base": point(1), "axis": axis}
    rays = []
    while len(rays) < 12:
        away = draw.choice([1, 1, 10, 1000]) if number != 1 else draw.choice([1, 10])
        origin, target = [away * x for x in point(4)], [b + x for b, x in zip(solid["base"], point(2))]
        direction = [b - a for a, b in zip(origin, target)]
        if any(direction):
            rays.append([origin, direction])
    return {"number": number, "solids": [solid], "rays": rays}


def agree(shown, wanted):
    """Exact answers: the same crossings; t as floats, the last bits of which are rounded in two ways."""
    return len(shown) == len(wanted) and all(
        a[1] == b[1] and math.isclose(a[0], b[0], rel_tol=1e-14, abs_tol=1e-280) for a, b in zip(shown, wanted))


def test_the_numbers_are_those_of_the_host(opened):
    page, draw = opened(), random.Random(7)
    worlds = [random_world(number, draw) for number in range(3) for _ in range(300)]
    wanted, counts = host(worlds), {"touch": 0, "hits": 0}
    for world, want in zip(worlds, wanted):
        shown = page.evaluate(IN_PAGE, world)
        assert ("refused" in shown) == ("refused" in want), (world, shown, want)
        if "refused" in want:
            assert shown["refused"] == want["refused"]
            continue
        assert shown["hits"] == want["hits"], world
        for ray, one, other in zip(world["rays"], shown["exact"], want["exact"]):
            assert agree(one, other), (world["number"], world["solids"], ray, one, other)
            counts["hits"] += len(other)
            counts["touch"] += sum(crossing == 2 for _, crossing in other)
    assert counts["hits"] > 5000 and counts["touch"] > 25


def test_the_pictures_are_those_of_the_host(opened):
    page = opened()
    scenes = page.evaluate("Object.values(SCENES).map(({ view, solids }) => ({ view, solids }))")
    worlds = []
    for scene in scenes:
        solids = [{**solid, "solid": SOLIDS.index(solid["name"])} for solid in scene["solids"]]
        for solid in solids:
            del solid["name"]
        view = {**scene["view"], "columns": 120, "rows": 90}
        worlds += [{"number": number, "solids": solids, "rays": [], "view": view} for number in range(3)]
    for world, want in zip(worlds, host(worlds)):
        shown = page.evaluate(IN_PAGE, world)
        assert shown["rows"] == want["rows"] and shown["rows"], world
