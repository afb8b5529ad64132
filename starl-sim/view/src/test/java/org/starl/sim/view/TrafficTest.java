package org.starl.sim.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.starl.sim.view.Runs.A;
import static org.starl.sim.view.Runs.B;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.sim.record.Flight;
import org.starl.sim.replay.Recording;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Sent;

class TrafficTest {

  private static final long MS = 1_000_000;

  private static final Instance MUTEX = Instance.of("mutex", "m");
  private static final Instance GEOCAST = Instance.of("geocast", "g");

  private record Req(int number) {
    static final RecordShape<Req> SHAPE =
        Shapes.of(Req.class, Shapes.part("number", Shapes.INT, Req::number), Req::new);
  }

  private static final Recording RECORDING =
      Runs.plain()
          .happens(new Sent(100 * MS, A, "bot1", MUTEX, 1, 50, Req.SHAPE, new Req(1)))
          .happens(new Delivered(200 * MS, B, A, MUTEX, 1, Req.SHAPE, new Req(1)))
          .happens(new Sent(300 * MS, B, "*", GEOCAST, 1, 50, Shapes.TEXT, "Copy"))
          .happens(new Dropped(400 * MS, A, "bot1", "loss"))
          .over(1000 * MS);

  private static List<Flight> at(Traffic traffic, long ms) {
    return traffic.at(ms * MS, RECORDING.firstAfter(ms * MS), 50 * MS, null);
  }

  @Test
  void aMessageIsInTransitBetweenSendingAndDelivery() {
    Traffic traffic = new Traffic(RECORDING);
    assertThat(at(traffic, 99)).isEmpty();
    Flight half = at(traffic, 150).get(0);
    assertThat(half.share()).isEqualTo(0.5);
    assertThat(half.state()).isEqualTo(Flight.State.IN_TRANSIT);
    assertThat(half.title()).isEqualTo("Req");
    assertThat(at(traffic, 220)).extracting(Flight::state).containsExactly(Flight.State.DELIVERED);
    assertThat(at(traffic, 260)).isEmpty();
  }

  @Test
  void aLostMessageIsShownAsDropped() {
    Traffic traffic = new Traffic(RECORDING);
    assertThat(at(traffic, 350)).extracting(Flight::state).containsExactly(Flight.State.IN_TRANSIT);
    Flight lost = at(traffic, 410).get(0);
    assertThat(lost.state()).isEqualTo(Flight.State.DROPPED);
    assertThat(lost.to()).isEqualTo(A);
  }

  @Test
  void messagesAreFilteredByChannelAndRobot() {
    Traffic traffic = new Traffic(RECORDING);
    traffic.only("geocast/g");
    assertThat(at(traffic, 150)).isEmpty();
    assertThat(at(traffic, 350)).hasSize(1);
    assertThat(traffic.channels()).containsExactly("geocast/g", "mutex/m");
    traffic.only("");
    traffic.onlyOfSelected(true);
    int index = RECORDING.firstAfter(150 * MS);
    assertThat(traffic.at(150 * MS, index, 0, new RobotId("bot9"))).isEmpty();
    assertThat(traffic.at(150 * MS, index, 0, B)).hasSize(1);
  }

  @Test
  void inALiveRunMessagesWithoutAnEndAreShown() {
    Recording young =
        Runs.plain()
            .happens(new Sent(100 * MS, A, "bot1", MUTEX, 1, 9, Shapes.TEXT, "Hi"))
            .recording();
    List<Flight> flights = new Traffic(young).at(110 * MS, young.size(), 0, null);
    assertThat(flights).hasSize(1);
    assertThat(new Traffic(young).at(5000 * MS, young.size(), 0, null)).isEmpty();
  }
}
