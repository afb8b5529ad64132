package org.starl.sim.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.MotionFact;
import org.starl.motion.MotionFailure;
import org.starl.shape.Shapes;
import org.starl.sim.record.Lanes.Change;
import org.starl.sim.record.Lanes.Kind;
import org.starl.sim.record.Lanes.Lane;
import org.starl.sim.record.Lanes.Tone;
import org.starl.trace.Holding;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

/** Lanes tell what each robot did over time. */
class LanesTest {

  private static final long S = 1_000_000_000;
  private static final RobotId A = new RobotId("bot0");
  private static final Instance MUTEX = Instance.of("mutex", "crossing");
  private static final Instance BARRIER = Instance.of("barrier", "b");
  private static final Var<String> LOCATION = Var.of("location", Shapes.TEXT);
  private static final Var<Integer> ROUNDS = Var.of("rounds", Shapes.INT);
  private static final Var<Boolean> CRIT = Var.of("crit", Shapes.BOOL);
  private static final Var<String> OUTCOME = Var.of("outcome", Shapes.TEXT);

  /** A fact that tells what is held. */
  private record took(String what) implements Holding {
    @Override
    public String holding() {
      return what.isEmpty() ? "" : "holds " + what;
    }
  }

  /** A fact that does not. */
  private record saw(String what) {}

  private final Lanes lanes = new Lanes();

  private <T> void variable(long atS, Instance source, Var<T> variable, T value) {
    lanes.observe(new TraceEvent.Variable(atS * S, A, source, variable, value));
  }

  private void took(long atS, String what) {
    lanes.observe(
        TraceEvent.Action.of(
            atS * S,
            A,
            MUTEX,
            Shapes.of(took.class, Shapes.part("what", Shapes.TEXT, took::what), took::new),
            new took(what)));
  }

  private void saw(long atS, Instance source, String what) {
    lanes.observe(
        TraceEvent.Action.of(
            atS * S,
            A,
            source,
            Shapes.of(saw.class, Shapes.part("what", Shapes.TEXT, saw::what), saw::new),
            new saw(what)));
  }

  private Lane lane(String name) {
    Lane lane = lanes.of(A).get(name);
    assertThat(lane).as(name).isNotNull();
    return lane;
  }

  private List<String> texts(String name) {
    return lane(name).changes().stream().map(Change::text).toList();
  }

  private void all() {
    lanes.observe(new TraceEvent.Joined(0, A, new Pose(0, 0, 0), 165));
    variable(0, BARRIER, OUTCOME, "none");
    variable(1, Instance.APP, LOCATION, "IDLE");
    variable(1, Instance.APP, ROUNDS, 1);
    variable(2, Instance.APP, LOCATION, "IDLE");
    variable(3, Instance.APP, LOCATION, "BUSY");
    variable(4, Instance.APP, ROUNDS, 5);
    took(2, "A");
    saw(3, MUTEX, "x");
    variable(3, MUTEX, CRIT, true);
    took(5, "");
    saw(6, BARRIER, "y");
    lanes.observe(
        TraceEvent.Action.of(
            7 * S,
            A,
            MotionFact.SOURCE,
            MotionFact.SHAPE,
            new MotionFact.failed(MotionFailure.BUMPED)));
    lanes.observe(new TraceEvent.Fault(8 * S, A, TraceEvent.Fault.CRASH, ""));
    lanes.observe(new TraceEvent.Sent(9 * S, A, "bot1", MUTEX, 1, 50, Shapes.TEXT, "REQ"));
    lanes.observe(new TraceEvent.Dropped(9 * S, A, "bot1", "loss"));
  }

  @Test
  void theAppComesFirstThenPrimitivesThenInstants() {
    all();
    assertThat(lanes.of(A).keySet())
        .containsExactly(
            "location", "rounds", "barrier/b", "mutex/crossing", "faults, bumps", "messages");
  }

  @Test
  void aStateLastsUntilAnotherAndANumberIsACurve() {
    all();
    assertThat(texts("location")).containsExactly("IDLE", "BUSY");
    assertThat(lane("rounds").kind()).isEqualTo(Kind.CURVE);
    assertThat(lane("rounds").changes()).extracting(Change::value).containsExactly(1.0, 5.0);
  }

  @Test
  void whatAnInstanceHoldsHidesItsOtherFacts() {
    all();
    assertThat(texts("mutex/crossing")).containsExactly("holds A", "");
    assertThat(texts("barrier/b")).containsExactly("outcome none", "saw y");
  }

  @Test
  void bumpsFaultsAndLostMessagesAreAlarms() {
    all();
    assertThat(lane("faults, bumps").changes())
        .extracting(Change::tone)
        .containsExactly(Tone.ALARM, Tone.ALARM);
    assertThat(lane("messages").changes())
        .extracting(Change::tone)
        .containsExactly(Tone.PLAIN, Tone.ALARM);
  }

  @Test
  void aLongLaneEndsAtItsLimit() {
    for (int i = 0; i < Lanes.MOST_CHANGES + 10; i++) {
      variable(i, Instance.APP, ROUNDS, i);
    }
    assertThat(lane("rounds").changes()).hasSize(Lanes.MOST_CHANGES);
  }

  @Test
  void aPlaceAndItsTimeBelongTogether() {
    LanePainter painter = new LanePainter(lanes, 2 * S, 12 * S, 800);
    for (long timeNs = 2 * S; timeNs <= 12 * S; timeNs += S / 3) {
      assertThat(painter.timeNs(painter.xPx(timeNs))).isBetween(timeNs - 2, timeNs + 2);
    }
    assertThat(painter.timeNs(0)).isEqualTo(2 * S);
    assertThat(painter.timeNs(9000)).isEqualTo(12 * S);
  }

  @Test
  void alarmsArePaintedInTheirLane() {
    all();
    BufferedImage image = new BufferedImage(800, 200, BufferedImage.TYPE_INT_RGB);
    LanePainter painter = new LanePainter(lanes, 0, 10 * S, 800);
    painter.paint(image.createGraphics(), Theme.LIGHT);
    int x = (int) Math.round(painter.xPx(8 * S));
    boolean isAlarm = false;
    for (int y = 0; y < image.getHeight(); y++) {
      isAlarm |= image.getRGB(x, y) == Theme.LIGHT.alarm().getRGB();
    }
    assertThat(isAlarm).isTrue();
    assertThat(painter.heightPx()).isEqualTo(painter.heightPx(A)).isLessThan(200);
    assertThat(Map.copyOf(lanes.of(A))).hasSize(6);
  }
}
