package org.starl.sim.view.page;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import org.starl.input.BadInput;
import org.starl.input.TextFile;
import org.starl.sim.Failure;
import org.starl.sim.record.BoundingBox;
import org.starl.sim.record.Flight;
import org.starl.sim.record.LanePainter;
import org.starl.sim.record.Lanes;
import org.starl.sim.record.Look;
import org.starl.sim.record.Painter.Section;
import org.starl.sim.record.Part;
import org.starl.sim.record.Theme;
import org.starl.sim.record.Viewport;
import org.starl.sim.replay.Cursor;
import org.starl.sim.replay.Mark;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.Traffic;
import org.starl.sim.view.ViewSettings;
import org.starl.time.Time;

/**
 * Writes a run as one HTML page that plays it: what the window shows, in a browser, without a
 * network.
 */
public final class RunPage {

  /** Usual simulated time between two pictures of a page, in ns; the browser interpolates. */
  public static final long EVERY_NS = 100 * Time.NS_PER_MS;

  private static final int WIDTH_PX = 960;
  private static final int LEAST_HEIGHT_PX = 360;
  private static final int MOST_HEIGHT_PX = 960;
  private static final int MARGIN_PX = 28;
  private static final String STYLE = TextFile.resource(RunPage.class, "player.css");

  private static final int MOST_PICTURES = 20_000;
  private static final int MOST_MESSAGES = 300;

  private final Recording recording;
  private final long everyNs;
  private final long fromNs;
  private final long toNs;

  /** The page of a whole recording, with a picture per {@link #EVERY_NS}; fewer of a long run. */
  public RunPage(Recording recording) {
    this(recording, Math.max(EVERY_NS, recording.endNs() / MOST_PICTURES + 1), 0, Long.MAX_VALUE);
  }

  /**
   * The page of a part of a recording.
   *
   * @param recording of a finished run
   * @param everyNs simulated time between two pictures, above 0
   * @param fromNs time of the first picture
   * @param toNs time of the last picture; the run's end if it is later
   * @throws BadInput if the page would have more than 20,000 pictures
   */
  public RunPage(Recording recording, long everyNs, long fromNs, long toNs) {
    this.recording = recording;
    this.everyNs = everyNs;
    this.fromNs = Math.max(0, fromNs);
    this.toNs = Math.max(this.fromNs, Math.min(toNs, recording.endNs()));
    if ((this.toNs - this.fromNs) / everyNs > MOST_PICTURES) {
      throw new BadInput(
          String.format(
              Locale.ROOT,
              "a page of %.0f s with a picture every %.3f s: expected at most %d pictures",
              Time.seconds(this.toNs - this.fromNs),
              Time.seconds(everyNs),
              MOST_PICTURES));
    }
  }

  /** Writes the page in UTF-8. */
  public void write(OutputStream out) throws IOException {
    out.write(html("", 0).getBytes(StandardCharsets.UTF_8));
  }

  /**
   * The page, with a mark on its time bar.
   *
   * @param mark what is there; empty for no mark
   */
  String html(String mark, long atNs) throws IOException {
    String title = title(recording);
    Map<String, Object> run = run(title);
    List<List<Object>> marks = marks(recording.marks(), fromNs, toNs);
    if (!mark.isEmpty()) {
      marks.add(List.of(millis(Math.min(toNs, atNs)), "DIFFERENCE", mark));
    }
    run.put("marks", marks);
    return page(title, "", packed(run));
  }

  /**
   * The page of a run that goes on.
   *
   * @param source the address of the parts of its {@link LivePage}, as events that a server sends
   */
  static String live(String title, String source) {
    return page(title, source, "");
  }

  private static String page(String title, String source, String run) {
    return TextFile.resource(RunPage.class, "player.html")
        .replace("{{style}}", STYLE)
        .replace("{{script}}", script())
        .replace("{{connect}}", source.isEmpty() ? "" : "; connect-src 'self'")
        .replace("{{title}}", escaped(title))
        .replace("{{source}}", escaped(source))
        .replace("{{run}}", run);
  }

  static String title(Recording recording) {
    return recording.header().scenario() + ", seed " + recording.header().scenarioSeed();
  }

  private Map<String, Object> run(String title) {
    Cursor cursor = new Cursor(recording);
    Viewport viewport = viewport(cursor);
    PageFrames frames = new PageFrames(viewport, look());
    Traffic traffic = new Traffic(recording);
    for (long timeNs = fromNs; frames.size() == 0 || timeNs < toNs + everyNs; timeNs += everyNs) {
      cursor.seek(Math.min(timeNs, toNs));
      // A message stays until the next picture, so that each is seen.
      List<Flight> messages = traffic.at(cursor.nowNs(), cursor.index(), everyNs, null);
      frames.add(cursor.scene(), cursor.layer(), messages);
    }
    Map<String, Object> run = head(title, viewport, everyNs, fromNs);
    run.put("toMs", millis(toNs));
    putFailure(run, recording);
    run.put("lanes", lanes(recording, frames, fromNs, toNs));
    run.put("sequence", sequence(recording, fromNs, toNs));
    run.put("texts", frames.texts());
    run.put("styles", frames.styles());
    run.put("frames", frames.frames());
    return run;
  }

  /** What a page knows of a run before its first picture. */
  static Map<String, Object> head(String title, Viewport viewport, long everyNs, long fromNs) {
    Map<String, Object> run = new LinkedHashMap<>();
    run.put("title", title);
    run.put("everyMs", millis(everyNs));
    run.put("fromMs", millis(fromNs));
    run.put("width", viewport.widthPx());
    run.put("height", viewport.heightPx());
    run.put("paper", List.of(css(Theme.LIGHT), css(Theme.DARK)));
    run.put("sections", Section.values());
    return run;
  }

  /** What went wrong, if anything did and it is known. */
  static void putFailure(Map<String, Object> run, Recording recording) {
    Failure failure = recording.wentWrong();
    if (failure != null) {
      Map<String, Object> fields = failure.fields();
      fields.put("ms", millis(failure.atNs()));
      fields.put("facts", failure.facts());
      run.put("failure", fields);
    }
  }

  /** The lanes of each robot, and the places of the first and the last picture in them. */
  static Map<String, Object> lanes(Recording recording, PageFrames frames, long fromNs, long toNs) {
    Lanes lanes = new Lanes();
    for (int i = 0; i < recording.size(); i++) {
      lanes.observe(recording.event(i));
    }
    LanePainter painter = new LanePainter(lanes, fromNs, toNs, WIDTH_PX);
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("width", WIDTH_PX);
    all.put("from", painter.xPx(fromNs));
    all.put("to", painter.xPx(toNs));
    all.put("robots", frames.lanes(painter));
    return all;
  }

  /** The latest messages before what went wrong, or before the end, as SVG; empty without any. */
  static String sequence(Recording recording, long fromNs, long toNs) {
    SequenceChart chart = new SequenceChart(MOST_MESSAGES);
    Failure failure = recording.wentWrong();
    long untilNs = failure == null ? toNs : Math.min(toNs, failure.atNs());
    int end = recording.firstAfter(untilNs);
    for (int i = recording.firstAfter(fromNs - 1); i < end; i++) {
      chart.observed(recording.event(i));
    }
    if (failure != null) {
      chart.decide(failure.robots(), failure.atNs());
    }
    chart.end(failure == null ? "the end" : failure.headline());
    return chart.isEmpty() ? "" : chart.svg();
  }

  Look look() {
    return look(recording);
  }

  /** As the window's at the start, with trails. */
  static Look look(Recording recording) {
    return ViewSettings.of(recording.header())
        .look()
        .with(Part.TRAILS, true)
        .withTrails(Integer.MAX_VALUE);
  }

  /** Shows all places where a robot has been at the end. */
  Viewport viewport(Cursor cursor) {
    cursor.seek(toNs);
    return viewport(BoundingBox.of(cursor.scene(), cursor.layer()));
  }

  static Viewport viewport(BoundingBox extent) {
    int heightPx = (int) (WIDTH_PX * extent.heightMm() / Math.max(1, extent.widthMm()));
    int limitedPx = Math.max(LEAST_HEIGHT_PX, Math.min(MOST_HEIGHT_PX, heightPx));
    return Viewport.fit(extent, WIDTH_PX, limitedPx, MARGIN_PX);
  }

  static List<List<Object>> marks(List<Mark> all, long fromNs, long toNs) {
    List<List<Object>> marks = new ArrayList<>();
    for (Mark mark : all) {
      if (mark.timeNs() >= fromNs && mark.timeNs() <= toNs) {
        marks.add(List.of(millis(mark.timeNs()), mark.kind(), mark.text()));
      }
    }
    return marks;
  }

  static double millis(long timeNs) {
    return (double) timeNs / Time.NS_PER_MS;
  }

  private static String css(Theme theme) {
    return PageFrames.css(theme.paper().getRGB());
  }

  /** As JSON, deflated, in base 64. */
  private static String packed(Map<String, Object> run) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream out =
        new DeflaterOutputStream(bytes, new Deflater(Deflater.BEST_COMPRESSION))) {
      new ObjectMapper().writeValue(out, run);
    }
    return Base64.getEncoder().encodeToString(bytes.toByteArray());
  }

  static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
  }

  /** The styles of every page; a page that embeds one allows them by their hashes. */
  public static List<String> styles() {
    return List.of(STYLE, SequenceChart.STYLE);
  }

  /** The script of every page. */
  public static String script() {
    return TextFile.resource(RunPage.class, "player.js");
  }
}
