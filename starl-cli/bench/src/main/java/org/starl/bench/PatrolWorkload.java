package org.starl.bench;

import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.shape.WireReader;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;

/**
 * B2, PATROL: the whole stack. N robots on a square grid 2 m apart drive back and forth, 600 mm to
 * either side, with the default motion parameters, positioning every 75 ms and collisions; each
 * sends an acknowledged message to the next one every tenth of its 100 ms rounds. 30 s.
 */
public final class PatrolWorkload implements Workload {

  private static final long ROUND_MS = 100;
  private static final int ROUNDS = 300;
  private static final double SPACING_MM = 2000;
  private static final double REACH_MM = 600;
  private static final int BEACON_EVERY = 10;

  private static final Channel<Long> CHANNEL =
      new Channel<>("bench", "b2", Codec.of((message, out) -> out.i64(message), WireReader::i64));

  @Override
  public String name() {
    return "b2";
  }

  @Override
  public String summary() {
    return "the whole stack: motion, positioning, collisions, acknowledged messages";
  }

  @Override
  public Simulation.Builder plan(int robots, Style style, long seed) {
    if (robots < 2) {
      throw new BadInput("b2: " + robots + " robots: expected 2 or more");
    }
    if (style != Style.BLOCKING) {
      throw new BadInput("b2: style step: expected blocking");
    }
    int side = (int) Math.ceil(Math.sqrt(robots));
    SimSettings settings = SimSettings.builder().set("messageDelay", "uniform(10ms,20ms)").build();
    Simulation.Builder builder = Simulation.builder().name("b2").seed(seed).settings(settings);
    for (int i = 0; i < robots; i++) {
      int me = i;
      int row = i / side;
      Pose start = new Pose(SPACING_MM * (i % side) + 1000, SPACING_MM * row + 1000, 0);
      RobotId id = new RobotId("bot" + i);
      RobotId next = new RobotId("bot" + (i + 1) % robots);
      builder.robot(new RobotSpec(id, start, true, gvh -> new Patrol(gvh, me, start, next)));
    }
    return builder;
  }

  private static final class Patrol extends LogicThread {
    private final int me;
    private final RobotId next;
    private final List<ItemPosition> ends;
    private final Endpoint<Long> endpoint;
    private int leg;
    private int received;

    Patrol(GlobalVarHolder gvh, int me, Pose start, RobotId next) {
      super(gvh);
      this.me = me;
      this.next = next;
      ends =
          List.of(
              new ItemPosition("right", start.xMm() + REACH_MM, start.yMm()),
              new ItemPosition("left", start.xMm() - REACH_MM, start.yMm()));
      endpoint = gvh.comms.open(CHANNEL, (from, beacon) -> received++);
    }

    @Override
    public List<Object> callStarL() {
      for (int round = 0; round < ROUNDS; round++) {
        if (!gvh.plat.moat.inMotion()) {
          gvh.plat.moat.doMove(ends.get(leg % ends.size()));
          leg++;
        }
        if ((round + me) % BEACON_EVERY == 0) {
          endpoint.sendReliably(next, (long) round);
        }
        sleep(ROUND_MS);
      }
      return List.of(leg, received);
    }
  }
}
