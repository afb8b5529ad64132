package org.starl.sim.view.page;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.awt.BasicStroke;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import org.starl.browser.Browser;
import org.starl.geometry.Circle;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.Deviation;
import org.starl.shape.Shapes;
import org.starl.sim.Failure;
import org.starl.sim.record.Figures;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Look;
import org.starl.sim.record.Painter;
import org.starl.sim.record.Scene;
import org.starl.sim.record.Theme;
import org.starl.sim.record.Viewport;
import org.starl.sim.replay.Cursor;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.Traffic;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.Var;

/** The page in a real browser, beside what the window's painter paints. */
@Tag("realtime")
class RunPageTest {

  private static final long MS = 1_000_000;
  private static final RobotId A = new RobotId("bot0");
  private static final RobotId B = new RobotId("bot1");
  private static final RobotId C = new RobotId("bot2");
  private static final Instance MUTEX = Instance.of("mutex", "m");
  private static final Var<String> LOCATION = Var.of("location", Shapes.TEXT);

  /** Greatest difference of a colour channel that smoothing may cause. */
  private static final int SMOOTHING = 70;

  /** Share of the canvas that may differ, because the browser's font is another. */
  private static final double SHARE_OF_TEXT = 0.008;

  @TempDir(cleanup = CleanupMode.ON_SUCCESS)
  static Path folder;

  private static final Recording RECORDING = recording();
  private static final RunPage PAGE = new RunPage(RECORDING);
  private static Optional<Browser> opened = Optional.empty();

  private static Browser browser() {
    return opened.orElseThrow();
  }

  /** Draws a zone with its name, a dotted route, and a mark over the robots. */
  private static final class Zone implements Layer {
    private int seen;

    @Override
    public Layer copy() {
      Zone copy = new Zone();
      copy.seen = seen;
      return copy;
    }

    @Override
    public void observe(TraceEvent event) {
      seen += event instanceof TraceEvent.Variable ? 1 : 0;
    }

    @Override
    public void paintFloor(Graphics2D floor, Scene scene, Look look) {
      floor.setColor(look.theme().shade());
      floor.fill(new Rectangle2D.Double(500, -300, 900, 700));
      floor.setColor(look.robot(scene, B));
      floor.setStroke(look.dots(30, 90));
      floor.draw(Figures.polygon(0, 0, 1500, 300, 1500, 1200));
      Graphics2D upright = (Graphics2D) floor.create();
      upright.transform(AffineTransform.getScaleInstance(1, -1));
      upright.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 200));
      upright.setColor(look.theme().muted());
      upright.drawString("zone " + seen, 520, 250);
      upright.dispose();
    }

    @Override
    public void paintOver(Graphics2D floor, Scene scene, Look look) {
      floor.setColor(look.theme().gold());
      floor.setStroke(new BasicStroke(20));
      floor.drawOval(1800, 800, 300 + 10 * seen, 200);
    }
  }

  /** Three robots for 6 s, a message in transit, a crash and a violation. */
  private static Recording recording() {
    Obstacle wall =
        new Obstacle(List.of(new Point(-400, 1600), new Point(2600, 1600)), false, false, 60_000);
    Recording run = new Recording(Obstacles.of(wall), new Zone());
    run.started(new TraceHeader("0", "<b>page</b>", 7, 8, Map.of(), List.of(A, B, C)));
    run.observed(new TraceEvent.Joined(0, A, Pose.of(new Point(0, 0), 0), 165));
    run.observed(new TraceEvent.Joined(0, B, Pose.of(new Point(2000, 0), 2), 165));
    run.observed(new TraceEvent.Joined(0, C, Pose.of(new Point(300, 1000), 0), 165));
    run.observed(new TraceEvent.Moved(0, A, Pose.of(new Point(0, 0), 0), 400, 0.3));
    run.observed(new TraceEvent.Moved(500 * MS, C, Pose.of(new Point(300, 1000), 0), 100, 0));
    run.observed(new TraceEvent.Variable(1000 * MS, A, Instance.APP, LOCATION, "REQUEST"));
    run.observed(
        new TraceEvent.Variable(
            1500 * MS, B, Deviation.SOURCE, Deviation.VAR, new Deviation(-500, 300, 1, 200, 1)));
    run.observed(new TraceEvent.Sent(2000 * MS, A, "bot1", MUTEX, 1, 50, Shapes.TEXT, "REQ[1]"));
    run.observed(new TraceEvent.Delivered(2700 * MS, B, A, MUTEX, 1, Shapes.TEXT, "REQ[1]"));
    run.observed(new TraceEvent.Fault(3000 * MS, C, TraceEvent.Fault.CRASH, ""));
    run.observed(new TraceEvent.Variable(4250 * MS, A, Instance.APP, LOCATION, "CRITICAL"));
    run.violated(new SpecReport.Violation("Exclusive", 4250 * MS, List.of(A), "two in one zone"));
    run.wentWrong(
        new Failure(
            Failure.Kind.VIOLATED,
            "Exclusive",
            "one at a time",
            "Exclusive violated",
            4250 * MS,
            List.of(new Failure.Culprit(A, null, Deviation.NONE)),
            new Circle(new Point(900, 200), 400),
            List.of(),
            "a <i>guess</i>",
            List.of("replay: again")));
    run.over(6000 * MS);
    return run;
  }

  @BeforeAll
  static void open() throws Exception {
    Path page = folder.resolve("run.html");
    try (OutputStream out = Files.newOutputStream(page)) {
      PAGE.write(out);
    }
    Path profile = Files.createDirectory(folder.resolve("profile"));
    opened = Optional.of(Browser.open(profile, page.toUri(), 1200, 1130));
  }

  @AfterAll
  static void close() throws Exception {
    if (opened.isPresent()) {
      assertThat(browser().errors()).isEmpty();
      browser().close();
    }
  }

  @BeforeEach
  void toTheStart() throws Exception {
    browser().evaluate("document.activeElement.blur()");
    browser().key("Escape");
    browser().key("Home");
    browser().key("f");
    if (!theme().equals("light")) {
      browser().key("d");
    }
  }

  private static String theme() throws Exception {
    return browser().evaluate("document.documentElement.dataset.theme").asText();
  }

  /** Moves the time bar, as dragging does. */
  private static void scrub(long ms) throws Exception {
    browser()
        .evaluate(
            "{ const bar = document.getElementById('time'); bar.value = "
                + ms
                + "; bar.dispatchEvent(new Event('input')); }");
  }

  private static double nowMs() throws Exception {
    return browser().evaluate("Number(document.getElementById('time').value)").asDouble();
  }

  @Test
  void aMessageInSequenceLeadsToItsMoment() throws Exception {
    browser().evaluate("document.querySelector('#messages summary').click()");
    assertThat(browser().evaluate("document.querySelectorAll('#sequence .row').length").asInt())
        .isEqualTo(2); // a message and a crash
    browser().evaluate("document.querySelector('#sequence .row').onclick()");
    assertThat(nowMs()).isEqualTo(2700);
    browser().await("document.querySelector('#sequence .now').dataset.ms === '2700.0'");
    String filter =
        "{ const list = document.getElementById('%s'); list.value = '%s'; list.onchange(); }";
    String shown =
        "[...document.querySelectorAll('#sequence .row')]"
            + ".filter(row => row.style.display === '').map(row => row.dataset.ms).join(' ')";
    browser().evaluate(filter.formatted("of", "bot2"));
    assertThat(browser().evaluate(shown).asText()).isEqualTo("3000.0");
    browser().evaluate(filter.formatted("of", ""));
    browser().evaluate(filter.formatted("on", MUTEX.name()));
    assertThat(browser().evaluate(shown).asText()).isEqualTo("2700.0");
    browser().evaluate(filter.formatted("on", ""));
    browser().evaluate("document.querySelector('#messages summary').click()");
  }

  /** How the page fits its pictures into the canvas. */
  private static AffineTransform fitted(Viewport viewport, JsonNode canvas) {
    double width = canvas.path("width").asDouble();
    double height = canvas.path("height").asDouble();
    double scale = Math.min(width / viewport.widthPx(), height / viewport.heightPx());
    AffineTransform fitted = new AffineTransform();
    fitted.translate(
        (width - scale * viewport.widthPx()) / 2, (height - scale * viewport.heightPx()) / 2);
    fitted.scale(scale, scale);
    return fitted;
  }

  /** A point on a body beside its name, in pixels of the canvas. */
  private static Point2D inCanvas(RobotId robot, long ms, JsonNode canvas) {
    Cursor cursor = new Cursor(RECORDING);
    Viewport viewport = PAGE.viewport(cursor);
    cursor.seek(ms * MS);
    Point at = cursor.scene().pose(robot).orElseThrow().at().plus(new Point(0, 100));
    Point2D inPage = new Point2D.Double(viewport.xPx(at), viewport.yPx(at));
    return fitted(viewport, canvas).transform(inPage, null);
  }

  /** What the window's painter paints at a time, where the page has its canvas. */
  private static BufferedImage painted(long ms, Theme theme, JsonNode canvas) {
    Cursor cursor = new Cursor(RECORDING);
    Viewport viewport = PAGE.viewport(cursor);
    cursor.seek(ms * MS);
    int width = canvas.path("width").asInt();
    int height = canvas.path("height").asInt();
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D page = image.createGraphics();
    page.setColor(theme.paper());
    page.fillRect(0, 0, width, height);
    page.transform(fitted(viewport, canvas));
    new Painter()
        .paint(
            page,
            cursor.scene(),
            cursor.layer(),
            viewport,
            PAGE.look().in(theme),
            new Traffic(RECORDING).at(ms * MS, cursor.index(), RunPage.EVERY_NS, null));
    page.dispose();
    return image;
  }

  private static JsonNode canvas() throws Exception {
    return browser()
        .evaluate(
            "(r => ({x: Math.round(r.x), y: Math.round(r.y), width: Math.round(r.width), height:"
                + " Math.round(r.height)}))(document.getElementById('floor').getBoundingClientRect())");
  }

  private static int difference(int a, int b) {
    int most = 0;
    for (int shift = 0; shift <= 16; shift += 8) {
      most = Math.max(most, Math.abs((a >> shift & 255) - (b >> shift & 255)));
    }
    return most;
  }

  /** Share of the canvas whose colour is not the painter's. */
  private static double wrongShare(long ms, Theme theme) throws Exception {
    scrub(ms);
    JsonNode at = canvas();
    BufferedImage expected = painted(ms, theme, at);
    BufferedImage actual = browser().screenshot();
    for (RobotId robot : List.of(A, B, C)) {
      Point2D body = inCanvas(robot, ms, at);
      int x = (int) body.getX();
      int y = (int) body.getY();
      int there = actual.getRGB(at.path("x").asInt() + x, at.path("y").asInt() + y);
      assertThat(difference(expected.getRGB(x, y), there))
          .as("%s at %d ms", robot, ms)
          .isLessThan(6);
    }
    int wrong = 0;
    for (int y = 0; y < expected.getHeight(); y++) {
      for (int x = 0; x < expected.getWidth(); x++) {
        int there = actual.getRGB(at.path("x").asInt() + x, at.path("y").asInt() + y);
        wrong += difference(expected.getRGB(x, y), there) > SMOOTHING ? 1 : 0;
      }
    }
    return (double) wrong / (expected.getWidth() * expected.getHeight());
  }

  @Test
  void thePageShowsWhatTheWindowPaints() throws Exception {
    // Forwards, with a message in transit, behind the crash, and back again.
    for (long ms : List.of(0L, 2300L, 5900L, 1200L)) {
      assertThat(wrongShare(ms, Theme.LIGHT)).as("light, at %d ms", ms).isLessThan(SHARE_OF_TEXT);
    }
    browser().key("d");
    for (long ms : List.of(2300L, 5900L)) {
      assertThat(wrongShare(ms, Theme.DARK)).as("dark, at %d ms", ms).isLessThan(SHARE_OF_TEXT);
    }
  }

  @Test
  void playingAdvancesTheTimeAndSpaceStopsIt() throws Exception {
    browser().key(" ");
    browser().await("document.getElementById('time').value > 300");
    assertThat(browser().text("#play")).isEqualTo("Pause");
    browser().key(" ");
    assertThat(browser().text("#play")).isEqualTo("Play");
    double stoppedMs = nowMs();
    browser()
        .evaluate("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))");
    assertThat(nowMs()).isEqualTo(stoppedMs);
  }

  @Test
  void arrowsGoFromPictureToPicture() throws Exception {
    browser().key("ArrowRight");
    browser().key("ArrowRight");
    assertThat(nowMs()).isEqualTo(200);
    browser().key("ArrowLeft");
    assertThat(nowMs()).isEqualTo(100);
    browser().key("End");
    assertThat(nowMs()).isEqualTo(6000);
    assertThat(browser().text("#clock")).isEqualTo("6.000 s of 6.000 s");
  }

  @Test
  void aClickOnARobotShowsItsVariablesOfThatTime() throws Exception {
    scrub(1500);
    JsonNode at = canvas();
    Point2D body = inCanvas(A, 1500, at);
    browser().click(at.path("x").asDouble() + body.getX(), at.path("y").asDouble() + body.getY());
    assertThat(browser().text("#selected")).isEqualTo("bot0");
    assertThat(browser().text("#state")).contains("REQUEST");
    scrub(4300);
    assertThat(browser().text("#state")).contains("CRITICAL").doesNotContain("REQUEST");
  }

  @Test
  void tabOnTheFloorSelectsRobotsInOrderAndThenLeaves() throws Exception {
    browser().evaluate("document.getElementById('floor').focus()");
    for (String robot : List.of("bot0", "bot1", "bot2")) {
      browser().key("Tab");
      assertThat(browser().text("#selected")).isEqualTo(robot);
    }
    browser().key("Escape");
    assertThat(browser().text("#selected")).isEqualTo("Select a robot");
  }

  @Test
  void aViolationHasAMarkOnTheTimeBarAndALine() throws Exception {
    double percent =
        browser()
            .evaluate("parseFloat(document.querySelector('#marks .VIOLATION').style.left)")
            .asDouble();
    assertThat(percent).isBetween(70.8, 70.9);
    assertThat(browser().text("#message")).isEmpty();
    browser().key("n");
    assertThat(nowMs()).isEqualTo(4250);
    assertThat(browser().text("#message")).contains("Exclusive", "two in one zone");
    browser().key("Home");
    browser().evaluate("document.querySelector('#marks .VIOLATION').click()");
    assertThat(nowMs()).isEqualTo(4250);
  }

  @Test
  void anAddressLeadsToAMomentAndARobotOtherwiseToWhatWentWrong() throws Exception {
    browser().evaluate("location.hash = '#t=2.5&robot=bot1'");
    browser().await("document.getElementById('time').value == 2500");
    assertThat(browser().text("#selected")).isEqualTo("bot1");
    browser().evaluate("location.hash = '#t=elsewhere&robot=nobody'");
    browser().await("document.getElementById('time').value == 4250");
    assertThat(browser().text("#selected")).isEqualTo("Select a robot");
    browser().evaluate("location.hash = ''");
    browser().await("document.getElementById('selected').textContent === 'bot0'");
    assertThat(nowMs()).isEqualTo(4250);
    assertThat(browser().text("#state")).contains("CRITICAL").doesNotContain("REQUEST");
    assertThat(browser().text("#failure"))
        .contains("Exclusive violated", "one at a time", "a <i>guess</i>", "replay: again");
    browser().key("ArrowRight");
    browser().key(" ");
    browser().key(" ");
    assertThat(browser().evaluate("location.hash").asText()).startsWith("#t=").endsWith("=bot0");
  }

  @Test
  void aClickInTheLanesGoesToThatMoment() throws Exception {
    JsonNode lanes =
        browser()
            .evaluate(
                "(r => ({x: r.x, y: r.y, width: r.width}))(document.querySelector('#lanes"
                    + " canvas').getBoundingClientRect())");
    browser()
        .click(
            lanes.path("x").asDouble() + lanes.path("width").asDouble() / 2,
            lanes.path("y").asDouble() + 20);
    assertThat(nowMs()).isBetween(2300.0, 2800.0);
    double linePx =
        browser().evaluate("parseFloat(document.getElementById('now').style.left)").asDouble();
    assertThat(linePx)
        .isBetween(lanes.path("width").asDouble() / 2 - 2, lanes.path("width").asDouble() / 2 + 2);
  }

  @Test
  void thePageLoadsNothingElse() throws Exception {
    assertThat(browser().evaluate("performance.getEntriesByType('resource').length").asInt())
        .isZero();
    assertThat(browser().text("h1")).isEqualTo("<b>page</b>, seed 7");
  }
}
