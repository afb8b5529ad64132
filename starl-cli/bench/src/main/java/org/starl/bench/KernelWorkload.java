package org.starl.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Function;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.RobotApp;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.shape.WireReader;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.time.Time;

/**
 * B1: N robots, each 100 times: wait 100 ms, send one message to a random other robot with an
 * exponential delay of mean 50 ms; the receiver counts. Phases are random in 0..100 ms. So there
 * are about 100 wake-ups and 100 deliveries per robot. No robot has a body.
 */
public final class KernelWorkload implements Workload {

  public static final int ROUNDS = 100;
  public static final long PERIOD_MS = 100;

  public static final Channel<Integer> CHANNEL =
      new Channel<>("bench", "b1", Codec.of((message, out) -> out.u8(message), WireReader::u8));

  @Override
  public String name() {
    return "b1";
  }

  @Override
  public String summary() {
    return "kernel, strands and radio: wait, send to a random robot, count";
  }

  @Override
  public Simulation.Builder plan(int robots, Style style, long seed) {
    if (robots < 2) {
      throw new BadInput("b1: " + robots + " robots: expected 2 or more");
    }
    List<RobotId> ids = new ArrayList<>();
    for (int i = 0; i < robots; i++) {
      ids.add(new RobotId("bot" + i));
    }
    SimSettings settings = SimSettings.builder().set("messageDelay", "exponential(50ms)").build();
    Optional<Suspending> suspending = ServiceLoader.load(Suspending.class).findFirst();
    if (style == Style.SUSPENDED && suspending.isEmpty()) {
      throw new BadInput("b1: style suspended needs StarL's module for Kotlin on the class path");
    }
    Simulation.Builder builder = Simulation.builder().name("b1").seed(seed).settings(settings);
    for (int i = 0; i < robots; i++) {
      int me = i;
      Function<GlobalVarHolder, RobotApp> app =
          gvh -> {
            Rng rng = gvh.plat.entropy.fork("b1");
            long phaseNs = rng.nextLong(0, PERIOD_MS * Time.NS_PER_MS - 1);
            return switch (style) {
              case BLOCKING -> new Blocking(gvh, ids, me, rng, phaseNs);
              case STEP -> new Stepping(gvh, ids, me, rng, phaseNs);
              case SUSPENDED -> suspending.get().robot(gvh, ids, me, rng, phaseNs);
            };
          };
      builder.robot(new RobotSpec(ids.get(i), new Pose(0, 0, 0), false, app));
    }
    return builder;
  }

  /** Makes the robots whose apps suspend: they are in Kotlin, and so in another module. */
  public interface Suspending {

    /**
     * The app of one robot.
     *
     * @param me its number in {@code ids}
     * @param phaseNs its first wait is longer by this
     */
    RobotApp robot(GlobalVarHolder gvh, List<RobotId> ids, int me, Rng rng, long phaseNs);
  }

  private static final class Blocking extends LogicThread {
    private final List<RobotId> ids;
    private final int me;
    private final Rng rng;
    private final long phaseNs;
    private final Endpoint<Integer> endpoint;
    private int received;

    Blocking(GlobalVarHolder gvh, List<RobotId> ids, int me, Rng rng, long phaseNs) {
      super(gvh);
      this.ids = ids;
      this.me = me;
      this.rng = rng;
      this.phaseNs = phaseNs;
      endpoint = gvh.comms.open(CHANNEL, (from, message) -> received += message);
    }

    @Override
    public List<Object> callStarL() {
      gvh.plat.strand.sleepUntil(gvh.plat.clock.nowNs() + phaseNs);
      for (int round = 0; round < ROUNDS; round++) {
        sleep(PERIOD_MS);
        sendToRandomRobot(endpoint, ids, me, rng);
      }
      return List.of(received);
    }
  }

  private static final class Stepping extends LogicThread {
    private final List<RobotId> ids;
    private final int me;
    private final Rng rng;
    private final Endpoint<Integer> endpoint;
    private int received;
    private int round;

    Stepping(GlobalVarHolder gvh, List<RobotId> ids, int me, Rng rng, long phaseNs) {
      super(gvh, PERIOD_MS, PERIOD_MS * Time.NS_PER_MS + phaseNs);
      this.ids = ids;
      this.me = me;
      this.rng = rng;
      endpoint = gvh.comms.open(CHANNEL, (from, message) -> received += message);
    }

    @Override
    protected boolean step() {
      sendToRandomRobot(endpoint, ids, me, rng);
      round++;
      return round < ROUNDS;
    }

    @Override
    protected List<Object> returnResults() {
      return List.of(received);
    }
  }

  /** Sends one message to a random robot but {@code me}. */
  public static void sendToRandomRobot(
      Endpoint<Integer> endpoint, List<RobotId> ids, int me, Rng rng) {
    int other = rng.nextInt(ids.size() - 1);
    endpoint.send(ids.get(other >= me ? other + 1 : other), 1);
  }
}
