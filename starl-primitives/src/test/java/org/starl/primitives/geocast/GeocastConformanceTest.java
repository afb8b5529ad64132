package org.starl.primitives.geocast;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Circle;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.conformance.ShownRun;
import org.starl.primitives.geocast.GeocastAutomaton.States;
import org.starl.spec.automaton.Fun;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;

/** The map from events to actions, line by line, and traces that are no runs of the theory. */
class GeocastConformanceTest {

  private static final Instance SOURCE = Instance.of(GeocastFact.GEOCAST, "news");
  private static final Region AREA = new Circle(new Point(0, 0), 1000);
  private static final long S = 1_000_000_000L;

  private final ShownRun<States, GeocastAction> run = new ShownRun<>(GeocastConformance::new);

  private void isAt(String robot, double xMm) {
    run.has(new Joined(0, new RobotId(robot), new Pose(xMm, 0, 0), 165));
  }

  private void acts(long timeNs, String robot, GeocastFact fact) {
    run.has(Action.of(timeNs, new RobotId(robot), SOURCE, GeocastFact.SHAPE, fact));
  }

  private void opens(long timeNs, String robot, long incarnation) {
    acts(timeNs, robot, new GeocastFact.Opened(new ProcessId(new RobotId(robot), incarnation)));
  }

  private void delivers(long timeNs, String robot, GeocastId id) {
    acts(timeNs, robot, new GeocastFact.deliver(id));
  }

  /** {@code a/n}. */
  private static GeocastId id(long n) {
    return new GeocastId(ProcessId.first(new RobotId("a"), 1), n);
  }

  private void drives(long timeNs, String robot, double xMm, double mmPerS) {
    run.has(new Moved(timeNs, new RobotId(robot), new Pose(xMm, 0, 0), mmPerS, 0));
  }

  private void casts(long timeNs, GeocastId id, long dNs) {
    acts(timeNs, "a", new GeocastFact.do_geocast(id, AREA, dNs));
  }

  private List<String> details() {
    run.ends(1_000_000 * S);
    return run.details();
  }

  @Test
  void eventsMapToTheActionsInTheTable() {
    isAt("a", 5000);
    isAt("b", 0);
    isAt("c", -2000);
    opens(0, "b", 1);
    casts(S, id(1), 10 * S);
    acts(S, "a", new GeocastFact.copy(id(1)));
    drives(2 * S, "c", -2000, 500);
    delivers(3 * S, "b", id(1));
    opens(4 * S, "b", 2);
    delivers(5 * S, "b", id(1));
    delivers(6 * S, "c", id(1));
    drives(8 * S, "c", 1000, 500); // leaves
    delivers(9 * S, "d", id(1)); // its body is unknown
    assertThat(details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "restart(b)",
            "dt(1000000000)",
            "move(b, [a/1])",
            "do_geocast(a/1, a/1, 10000000000)",
            "dt(2000000000)",
            "deliver(a/1, b)",
            "dt(1000000000)",
            "restart(b)",
            "dt(1000000000)",
            "deliver(a/1, b)",
            "dt(1000000000)",
            "move(c, [a/1])",
            "deliver(a/1, c)",
            "dt(3000000000)",
            "move(d, [a/1])",
            "deliver(a/1, d)");
  }

  @Test
  void everyRobotIsEverywhereWithoutAMove() {
    isAt("b", 5000);
    acts(S, "a", new GeocastFact.BCast(id(1), new Everywhere(), 10 * S));
    delivers(2 * S, "b", id(1));
    delivers(3 * S, "c", id(1)); // its body is unknown
    assertThat(details()).isEmpty();
    assertThat(run.steps())
        .containsExactly(
            "dt(1000000000)",
            "do_geocast(a/1, everywhere, 10000000000)",
            "dt(1000000000)",
            "deliver(a/1, b)",
            "dt(1000000000)",
            "deliver(a/1, c)");
  }

  @Test
  void deliveryToARobotOutsideTheAreaDeviates() {
    isAt("b", -2000);
    drives(0, "b", -2000, 500);
    casts(0, id(1), 10 * S);
    delivers(S, "b", id(1));
    drives(5 * S, "b", 500, 0);
    assertThat(details())
        .containsExactly(
            SOURCE + ": deliver(a/1, b) is not enabled: i in was_in(m) is false: was_in(a/1) = ()");
  }

  @Test
  void aRobotThatHasLeftTheAreaMayDeliver() {
    isAt("b", 0);
    drives(0, "b", 0, 500);
    casts(S, id(1), 10 * S);
    delivers(9 * S, "b", id(1));
    assertThat(details()).isEmpty();
  }

  @Test
  void aSecondDeliveryDeviates() {
    isAt("b", 0);
    casts(0, id(1), 10 * S);
    delivers(S, "b", id(1));
    delivers(2 * S, "b", id(1));
    assertThat(details())
        .containsExactly(
            SOURCE
                + ": deliver(a/1, b) is not enabled: not i in got(m) is false: got(a/1) = (b:"
                + " true)");
  }

  @Test
  void aMessageMayBeDeliveredUntilTheEndOfItsInterval() {
    isAt("b", 0);
    isAt("c", 0);
    casts(S, id(1), 10 * S);
    delivers(11 * S, "b", id(1));
    delivers(11 * S + 1, "c", id(1));
    assertThat(details())
        .containsExactly(SOURCE + ": deliver(a/1, c) is not enabled: open?(m) is false: sent = []");
  }

  @Test
  void aReusedIdDeviates() {
    isAt("b", 0);
    casts(0, id(1), 10 * S);
    casts(S, id(1), 10 * S);
    assertThat(details())
        .containsExactly(
            SOURCE
                + ": do_geocast(a/1, a/1, 10000000000) is not enabled: not m in sent is false:"
                + " sent = [a/1]");
  }

  @Test
  void finishedMessagesAreForgotten() {
    isAt("b", 0);
    for (int n = 1; n <= 100; n++) {
      casts(n * S, id(n), S / 2);
      delivers(n * S + 1, "b", id(n));
    }
    assertThat(details()).isEmpty();
    States last = run.state();
    for (Fun<?, ?> ofMessages :
        List.of(last.t0(), last.d(), last.area(), last.got(), last.was_in(), last.was_out())) {
      assertThat(ofMessages.size()).isEqualTo(1);
    }
    assertThat(last.sent()).containsExactly("a/100");
    assertThat(last.pos().at(new RobotId("b")).areas()).containsExactly("a/100");
  }
}
