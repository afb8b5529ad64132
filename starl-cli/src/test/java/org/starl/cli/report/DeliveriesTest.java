package org.starl.cli.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.cli.TraceLines;
import org.starl.comms.Codec;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.Var;

class DeliveriesTest {

  private static final RobotId BOT0 = new RobotId("bot0");
  private static final RobotId BOT1 = new RobotId("bot1");
  private static final String MUTEX = "mutex/crossing";

  private static final Var<String> LOCATION = Var.of("location", Shapes.TEXT);

  private record Ask() {}

  private record Hello() {}

  private record Here() {}

  private record Nack() {}

  private record Ok() {}

  private record Query() {}

  private record Req() {}

  private record Vote() {}

  private final DeliveryCounter counter = new DeliveryCounter();

  private void action(RobotId robot, String source, String fact) {
    counter.observed(TraceLines.action(0, robot, source, fact));
  }

  private void asks() {
    action(
        BOT1,
        MUTEX,
        "{\"do_mutex\":{\"who\":\"bot1\",\"num\":1,\"ts\":1,\"want\":[\"A\"],\"sequence\":[],\"resumes\":false,\"known\":[]}}");
  }

  private void at(RobotId robot, String location) {
    counter.observed(new TraceEvent.Variable(0, robot, Instance.APP, LOCATION, location));
  }

  private void delivered(RobotId robot, String channel, Object message) {
    counter.observed(
        new TraceEvent.Delivered(
            0, robot, BOT0, Instance.named(channel), 1, Codec.text(), message));
  }

  private List<String> cells() {
    List<String> cells = new ArrayList<>();
    for (Deliveries.Table table : counter.deliveries().tables()) {
      for (Deliveries.Place place : table.places()) {
        place
            .types()
            .forEach((type, count) ->
                cells.add(
                    "%s %s %s %s %d"
                        .formatted(table.channel(), type, place.phase(), place.location(), count)));
      }
    }
    return cells;
  }

  @Test
  void aDeliveryCountsInThePhaseAndLocationOfItsReceiver() {
    at(BOT1, "WAIT");
    delivered(BOT1, MUTEX, new Req());
    asks();
    delivered(BOT1, MUTEX, new Ok());
    delivered(BOT1, MUTEX, new Ok());
    delivered(BOT0, MUTEX, new Ok());
    at(BOT1, "CROSS");
    delivered(BOT1, MUTEX, new Ok());
    assertThat(cells())
        .containsExactly(
            "mutex Ok IDLE - 1",
            "mutex Req IDLE WAIT 1",
            "mutex Ok TRYING CROSS 1",
            "mutex Ok TRYING WAIT 2");
  }

  @Test
  void aCrashEndsPhaseAndLocation() {
    at(BOT1, "WAIT");
    asks();
    delivered(BOT1, MUTEX, new Ok());
    counter.observed(new TraceEvent.Fault(0, BOT1, TraceEvent.Fault.CRASH, ""));
    delivered(BOT1, MUTEX, new Ok());
    assertThat(cells()).containsExactly("mutex Ok IDLE - 1", "mutex Ok TRYING WAIT 1");
  }

  @Test
  void instancesHavePhasesOfTheirOwnAndASynodThatOfItsPrimitive() {
    action(BOT1, "barrier/a", "{\"arrive\":{\"i\":\"bot1\",\"g\":1}}");
    delivered(BOT1, "barrier/a", new Here());
    delivered(BOT1, "barrier/b", new Here());
    delivered(BOT1, "barrier.synod/a", new Nack());
    delivered(BOT1, "own/x", new Hello());
    assertThat(cells())
        .containsExactly(
            "barrier Here IDLE - 1",
            "barrier Here WAITING - 1",
            "barrier.synod Nack WAITING - 1",
            "own Hello - - 1");
  }

  @Test
  void theLineNamesTheWidestGapsFirst() {
    at(BOT1, "WAIT");
    delivered(BOT1, "tubes/x", new Ask());
    delivered(BOT1, "tubes/x", new Vote());
    at(BOT1, "GO");
    delivered(BOT1, "tubes/x", new Ask());
    counter.observed(TraceLines.variable(0, BOT1, "tubes/x", "tubeflag", "\"MOVING\""));
    delivered(BOT1, "tubes/x", new Ask());
    assertThat(counter.deliveries().lines())
        .containsExactly(
            "deliveries of tubes: 4 of 21 combinations of type, phase and location; never: all in"
                + " PLANNING, all in CLAIMING, all in DONE, all in FAIL, Refuse, Vote in MOVING,"
                + " Vote in IDLE at GO");
  }

  @Test
  void theLineIsBounded() {
    delivered(BOT1, "registration/x", new Query());
    delivered(BOT1, "registration/x", new Nack());
    assertThat(counter.deliveries().lines())
        .containsExactly(
            "deliveries of registration: 2 of 35 combinations of type and phase; never: all in"
                + " JOINING, all in IN, all in LEAVING, all in LEFT_HALFWAY, Prepare, Promise, Accept,"
                + " Accepted and 1 more");
  }

  @Test
  void runsAddUp() {
    delivered(BOT1, MUTEX, new Ok());
    Coverage sum = new Coverage();
    sum.add(Coverage.of(new SpecReport(), counter));
    sum.add(Coverage.of(new SpecReport(), counter));
    assertThat(sum.deliveries().get(0).places().get(0).count("Ok")).isEqualTo(2);
    assertThat(cells()).containsExactly("mutex Ok IDLE - 1");
  }
}
