package org.starl.sim.view.page;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.Size;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.sim.record.Layer;
import org.starl.sim.record.Painter.Section;
import org.starl.sim.replay.Recording;
import org.starl.spec.SpecReport;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;
import org.starl.trace.Var;

/** The parts of a page whose run grows. */
class LivePageTest {

  private static final long MS = 1_000_000;
  private static final RobotId BOT = new RobotId("bot0");
  private static final List<String> LISTS = List.of("marks", "texts", "styles", "frames");
  private static final Var<String> PLACE = Var.of("location", Shapes.TEXT);
  private static final ObjectMapper JSON = new ObjectMapper();

  private static Recording begun() {
    Recording recording = new Recording(Obstacles.NONE, Layer.NONE);
    recording.started(new TraceHeader("0", "wander", 7, 8, Map.of(), List.of(BOT)));
    recording.observed(new TraceEvent.Joined(0, BOT, new Pose(0, 0, 0), 150));
    return recording;
  }

  /** Goes on by some ms: the robot drives, and tells where it is. */
  private static void goOn(Recording recording, int ms, int number) {
    long atNs = recording.endNs() + ms * MS;
    recording.observed(new TraceEvent.Moved(atNs, BOT, new Pose(30 * number, 0, 0), 100, 0));
    recording.observed(new TraceEvent.Variable(atNs, BOT, Instance.APP, PLACE, "S_" + number));
    if (number % 5 == 4) {
      recording.violated(new SpecReport.Violation("Exclusive", atNs, List.of(BOT), "two"));
    }
  }

  /** Takes all parts from {@code taken} on. */
  private static void take(LivePage page, List<LivePage.Part> taken) {
    for (LivePage.Part part = page.part(taken.size());
        part != null;
        part = page.part(taken.size())) {
      taken.add(part);
    }
  }

  /** The page that a browser has after these parts. */
  private static ObjectNode joined(List<LivePage.Part> parts) throws Exception {
    ObjectNode page = JSON.createObjectNode();
    for (LivePage.Part part : parts) {
      JsonNode read = JSON.readTree(part.json());
      assertThat(part.isFirst()).isEqualTo(page.isEmpty());
      if (part.isFirst()) {
        page.setAll((ObjectNode) read);
      } else {
        read.properties()
            .forEach(entry -> {
              if (LISTS.contains(entry.getKey())) {
                ((ArrayNode) page.get(entry.getKey())).addAll((ArrayNode) entry.getValue());
              } else {
                page.set(entry.getKey(), entry.getValue());
              }
            });
      }
    }
    return page;
  }

  @Property(tries = 40)
  void theTimesAtWhichABrowserAsksDoNotChangeThePage(
      @ForAll @Size(min = 1, max = 12) List<@IntRange(min = 1, max = 900) Integer> stepsMs,
      @ForAll @Size(12) List<Boolean> asks)
      throws Exception {
    Recording recording = begun();
    LivePage often = new LivePage(recording, 1);
    LivePage once = new LivePage(recording, 1);
    List<LivePage.Part> partsOfOften = new ArrayList<>();
    for (int i = 0; i < stepsMs.size(); i++) {
      goOn(recording, stepsMs.get(i), i);
      if (asks.get(i)) {
        take(often, partsOfOften);
      }
      assertThat(often.isWhole()).isFalse();
    }
    recording.over(recording.endNs());
    take(often, partsOfOften);
    List<LivePage.Part> partsOfOnce = new ArrayList<>();
    take(once, partsOfOnce);
    assertThat(often.isWhole()).isTrue();
    ObjectNode page = joined(partsOfOnce);
    // Names of the first trails may come in another order, so texts are compared by what is shown.
    assertThat(joined(partsOfOften).get("toMs")).isEqualTo(page.get("toMs"));
    assertThat(joined(partsOfOften).get("marks")).isEqualTo(page.get("marks"));
    assertThat(joined(partsOfOften).get("frames")).hasSize(page.get("frames").size());
    assertThat(page.get("toMs").asDouble()).isEqualTo(recording.endNs() / 1e6);
    assertThat(page.get("isOver").asBoolean()).isTrue();
    assertThat(page.get("frames")).hasSize((int) Math.ceil(recording.endNs() / 1e8) + 1);
  }

  @Example
  void thePageOfALongRunHasFewerPictures() throws IOException {
    Recording recording = begun();
    recording.over(2 * 3_600_000 * MS);
    ByteArrayOutputStream page = new ByteArrayOutputStream();
    new RunPage(recording).write(page);
    assertThat(page.size()).isPositive();
  }

  @Example
  void whoComesLaterGetsTheSameParts() {
    Recording recording = begun();
    LivePage page = new LivePage(recording, 1);
    List<LivePage.Part> first = new ArrayList<>();
    for (int i = 0; i < 9; i++) {
      goOn(recording, 200, i);
      take(page, first);
    }
    recording.over(recording.endNs());
    take(page, first);
    List<LivePage.Part> second = new ArrayList<>();
    take(page, second);
    assertThat(second).isEqualTo(first).hasSizeGreaterThan(5);
  }

  @Example
  void aPictureHasAllEventsOfItsMoment() {
    Recording recording = begun();
    LivePage page = new LivePage(recording, 1);
    recording.reached(100 * MS);
    assertThat(page.part(0)).isNotNull(); // the picture at 0
    assertThat(page.part(1)).isNull(); // more events of 100 ms may come
    recording.reached(101 * MS);
    assertThat(page.part(1)).isNotNull();
  }

  @Example
  void afterManyPicturesAPageBeginsAgain() throws Exception {
    Recording recording = begun();
    LivePage page = new LivePage(recording, 1, 10, Long.MAX_VALUE);
    List<LivePage.Part> parts = new ArrayList<>();
    int next = 0;
    for (int i = 0; i < 30; i++) {
      goOn(recording, 100, i);
      LivePage.Part part = page.part(next);
      if (part != null) {
        parts.add(part);
        next = part.number() + 1;
      }
    }
    assertThat(parts.stream().filter(LivePage.Part::isFirst)).hasSize(3);
    LivePage.Part late = page.part(0);
    assertThat(late).isNotNull();
    assertThat(late.isFirst()).isTrue();
    assertThat(late.number()).isPositive();
    JsonNode read = JSON.readTree(late.json());
    assertThat(read.get("fromMs").asDouble()).isGreaterThan(1000);
    assertThat(read.get("texts")).isNotEmpty();
  }

  @Example
  void aRobotThatLeavesThePictureEnlargesTheBox() throws Exception {
    Recording recording = begun();
    LivePage page = new LivePage(recording, 1);
    goOn(recording, 200, 1);
    List<LivePage.Part> parts = new ArrayList<>();
    take(page, parts);
    recording.observed(
        new TraceEvent.Moved(recording.endNs() + 1, BOT, new Pose(1e5, 0, 0), 10, 0));
    recording.reached(recording.endNs() + 300 * MS);
    take(page, parts);
    double before = JSON.readTree(parts.get(0).json()).get("box").get(2).asDouble();
    double after = JSON.readTree(parts.get(parts.size() - 1).json()).get("box").get(2).asDouble();
    assertThat(after).isGreaterThan(10 * before);
  }

  /** Whatever its pictures weigh, a page keeps few, and says from when on. */
  @Property(tries = 20)
  void aPageKeepsALimitedNumberOfCharacters(
      @ForAll @Size(min = 20, max = 40) List<@IntRange(min = 0, max = 3000) Integer> lengths)
      throws Exception {
    long limit = 20_000;
    Recording recording = begun();
    LivePage page = new LivePage(recording, 1, 20_000, limit);
    LivePage.Part first = null;
    int next = 0;
    long kept = 0;
    for (int i = 0; i < lengths.size(); i++) {
      goOn(recording, 100, i);
      recording.observed(
          new TraceEvent.Variable(
              recording.endNs(), BOT, Instance.APP, PLACE, i + "x".repeat(lengths.get(i))));
      for (LivePage.Part part = page.part(next); part != null; part = page.part(next)) {
        next = part.number() + 1;
        first = part.isFirst() ? part : first;
        kept = part.isFirst() ? 0 : kept;
        assertThat(kept).isLessThanOrEqualTo(limit);
        kept += part.json().length();
      }
    }
    JsonNode begin = JSON.readTree(Objects.requireNonNull(first).json());
    assertThat(begin.get("leftOut").asText())
        .isEqualTo(
            begin.get("fromMs").asDouble() == 0
                ? ""
                : "Pictures before %s are left out: a page that grows keeps only the latest"
                    .formatted(Time.text(begin.get("fromMs").asLong() * MS, 1)));
  }

  @Example
  void aRobotOutsideOfTheFirstPictureIsDrawnAndNamed() throws Exception {
    Recording recording = begun();
    LivePage page = new LivePage(recording, 1);
    List<LivePage.Part> parts = new ArrayList<>();
    recording.reached(50 * MS);
    take(page, parts);
    recording.observed(new TraceEvent.Moved(60 * MS, BOT, new Pose(1e5, 0, 0), 10, 0));
    recording.reached(150 * MS);
    take(page, parts);
    JsonNode frame = JSON.readTree(parts.get(parts.size() - 1).json()).at("/frames/0");
    for (Section section : List.of(Section.ROBOTS, Section.LABELS)) {
      assertThat(frame.get(section.ordinal()).toString()).as("%s", section).isNotEqualTo("[0]");
    }
  }
}
