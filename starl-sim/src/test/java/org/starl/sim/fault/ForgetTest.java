package org.starl.sim.fault;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.id.RobotId;
import org.starl.shape.WireReader;
import org.starl.sim.SimResult;
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

  /** Writes one variable with each message and another one once; tells which message was the last to survive. */
  private static final class Busy extends LogicThread {
    private static final int RARE = 10;

    Busy(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Endpoint<Integer> endpoint =
          gvh.comms.open(new Channel<>("promise", "x", CODEC), (from, n) -> {});
      for (int i = 1; i <= 2 * RARE && gvh.id.boot() == 1; i++) {
        sleep(500);
        gvh.plat.stable.put(i == RARE ? "rare" : "often", new byte[] {(byte) i}, () -> {});
        endpoint.send(new RobotId("bot1"), i);
      }
      sleep(20_000);
      byte[] often = gvh.plat.stable.get("often");
      return List.of(often == null ? 0 : often[0]);
    }
  }

  @Test
  void someWaitForAWriteThatIsRare() {
    Set<Object> survived = new HashSet<>();
    for (int ms = 100; ms < 110; ms++) {
      SimResult result =
          Simulation.builder()
              .robots(2, Busy::new)
              .fault("forget(bot0," + ms + "ms,2s,at=3200ms,until=15s)")
              .build()
              .run();
      survived.addAll(result.results().get(new RobotId("bot0")));
    }
    assertThat(survived).containsExactlyInAnyOrder((byte) 6, (byte) (Busy.RARE - 1));
  }

  @Test
  void aProgramThatWaitsForItsWriteIsSpared() {
    assertThat(run(true)).contains("bot0=[1, true]");
    assertThat(heard).containsExactly(7);
  }
}
