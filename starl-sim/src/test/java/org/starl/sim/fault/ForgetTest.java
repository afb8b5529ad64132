package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.id.RobotId;
import org.starl.shape.WireReader;
import org.starl.sim.Simulation;

/** The fault crashes a program that sends before its write survives, and no other. */
class ForgetTest {

  private static final Codec<Integer> CODEC =
      Codec.of((number, out) -> out.i32(number), WireReader::i32);

  private final List<Integer> heard = new ArrayList<>();

  /** bot0 promises a number, which it stores; then it tells how it has restarted. */
  private final class Promising extends LogicThread {
    private final boolean waits;
    private boolean isStored;

    Promising(GlobalVarHolder gvh, boolean waits) {
      super(gvh);
      this.waits = waits;
    }

    @Override
    public List<Object> callStarL() {
      Endpoint<Integer> endpoint =
          gvh.comms.open(new Channel<>("promise", "x", CODEC), (from, n) -> heard.add(n));
      sleep(1_000);
      if (gvh.id.name().name().equals("bot0") && gvh.id.boot() == 1) {
        gvh.plat.stable.put("promise", new byte[1], () -> isStored = true);
        await(() -> isStored || !waits);
        endpoint.send(new RobotId("bot1"), 7);
        sleep(20_000);
      }
      sleep(5_000);
      return List.of(gvh.id.boot(), gvh.plat.stable.get("promise") != null);
    }
  }

  private String run(boolean waits) {
    return Simulation.builder()
        .robots(2, gvh -> new Promising(gvh, waits))
        .fault("forget(bot0,100ms,2s,at=500ms,until=10s)")
        .build()
        .run()
        .results()
        .toString();
  }

  @Test
  void aProgramThatSendsTooEarlyForgetsWhatItHasSaid() {
    assertThat(run(false)).contains("bot0=[2, false]");
    assertThat(heard).containsExactly(7);
  }

  @Test
  void aProgramThatWaitsForItsWriteIsSpared() {
    assertThat(run(true)).contains("bot0=[1, true]");
    assertThat(heard).containsExactly(7);
  }
}
