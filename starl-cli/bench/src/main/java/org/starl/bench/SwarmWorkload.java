package org.starl.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.body.Bumps;
import org.starl.body.WheelCommand;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.geometry.Angles;
import org.starl.geometry.Obstacle;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.sim.net.Latency;
import org.starl.time.Time;

/**
 * B3, SWARM: N robots on a square floor of 2 m^2 a robot, with 10 ticks a second, diffuse: straight
 * on at 100 mm/s, and a turn away from what is near. In variants {@link Variant#RADIO} and {@link
 * Variant#SIGHT} every robot broadcasts its position in every tick, heard within 3 m with a loss of
 * 10 %, and turns away from what it heard nearby; bodies do not collide. In variant {@link
 * Variant#DISCS} robots have no radio and no position; bodies collide, and a bumped robot turns.
 */
public final class SwarmWorkload implements Workload {

  /** What the robots sense. */
  public enum Variant {
    /** Others in radio range. */
    RADIO("b3a", "radio of limited range"),
    /** Others in radio range and in sight: bodies and walls cut it. */
    SIGHT("b3b", "the same, cut by bodies and walls"),
    /** What they bump into. */
    DISCS("b3c", "no radio, discs that collide");

    private final String name;
    private final String summary;

    Variant(String name, String summary) {
      this.name = name;
      this.summary = summary;
    }
  }

  private static final long TICK_MS = 100;
  private static final double MM2_A_ROBOT = 2e6;
  private static final double RANGE_MM = 3000;
  private static final double LOSS = 0.1;
  private static final long DELAY_NS = 10 * Time.NS_PER_MS;
  private static final double NEAR_MM = 500;
  private static final int ROBOTS_A_WALL = 20;
  private static final double WALL_MM = 1000;

  private static final long ROBOT_TICKS = 600_000;
  private static final long LEAST_TICKS = 100;
  private static final long MOST_TICKS = 3000;

  private static final WheelCommand STRAIGHT = new WheelCommand(100, 0);
  private static final WheelCommand LEFT = new WheelCommand(0, 1.5);
  private static final WheelCommand RIGHT = new WheelCommand(0, -1.5);

  private static final Channel<Point> CHANNEL =
      new Channel<>(
          "bench",
          "b3",
          Codec.of(
              (at, out) -> {
                out.f64(at.xMm());
                out.f64(at.yMm());
              },
              in -> new Point(in.f64(), in.f64())));

  private final Variant variant;

  public SwarmWorkload(Variant variant) {
    this.variant = variant;
  }

  @Override
  public String name() {
    return variant.name;
  }

  @Override
  public String summary() {
    return "a swarm that diffuses: " + variant.summary;
  }

  @Override
  public Style style() {
    return Style.STEP;
  }

  /** The side of the floor in mm. */
  static double sideMm(int robots) {
    return Math.sqrt(MM2_A_ROBOT * robots);
  }

  /** 300 simulated seconds for 100 robots, 60 s for 1,000, and 10 s for 10,000. */
  static long ticks(int robots) {
    return Math.max(LEAST_TICKS, Math.min(MOST_TICKS, ROBOT_TICKS / robots));
  }

  @Override
  public Simulation.Builder plan(int robots, Style style, long seed) {
    if (style != Style.STEP) {
      throw new BadInput(name() + ": style blocking: expected step");
    }
    return plan(robots, ticks(robots), seed);
  }

  /** A run of {@code ticks} ticks. */
  Simulation.Builder plan(int robots, long ticks, long seed) {
    double sideMm = sideMm(robots);
    boolean collide = variant == Variant.DISCS;
    SimSettings.Builder settings =
        SimSettings.builder()
            .floorWidth(sideMm)
            .floorHeight(sideMm)
            .idealMotion(!collide)
            .messageDelay(new Latency.Constant(DELAY_NS))
            .messageLoss(LOSS)
            // Without radio there is nothing that needs a position: no fix in the run.
            .positionPeriod(collide ? Duration.ofHours(1) : Duration.ofMillis(TICK_MS))
            .positionInPhase(!collide);
    if (!collide) {
      settings.radioRange(RANGE_MM).radioSight(variant == Variant.SIGHT);
    }
    return Simulation.builder()
        .name(name())
        .seed(seed)
        .settings(settings.build())
        .obstacles(walls(robots, seed))
        .robots(robots, gvh -> collide ? new Disc(gvh, ticks) : new Talker(gvh, ticks, sideMm));
  }

  /** Those around the floor and, where they cut the sight, some on it, drawn by seed. */
  private Obstacles walls(int robots, long seed) {
    double sideMm = sideMm(robots);
    List<Obstacle> walls = new ArrayList<>();
    if (variant == Variant.DISCS) {
      walls.add(
          Obstacle.wall(
              new Point(0, 0),
              new Point(sideMm, 0),
              new Point(sideMm, sideMm),
              new Point(0, sideMm),
              new Point(0, 0)));
    } else if (variant == Variant.SIGHT) {
      Rng rng = new Rng(seed).fork("walls");
      for (int i = 0; i < robots / ROBOTS_A_WALL; i++) {
        Point from = new Point(rng.nextDouble() * sideMm, rng.nextDouble() * sideMm);
        double rad = 2 * StrictMath.PI * rng.nextDouble();
        Point along = new Point(WALL_MM * StrictMath.cos(rad), WALL_MM * StrictMath.sin(rad));
        walls.add(Obstacle.wall(from, from.plus(along)));
      }
    }
    return new Obstacles(walls);
  }

  /** Broadcasts its position, and turns away from others that it heard nearby, and from edges. */
  private static final class Talker extends LogicThread {
    private final Endpoint<Point> endpoint;
    private final long ticks;
    private final double sideMm;
    private double xMm;
    private double yMm;
    private double headingRad;
    private WheelCommand next = STRAIGHT;
    private long tick;
    private long heard;

    Talker(GlobalVarHolder gvh, long ticks, double sideMm) {
      super(gvh, TICK_MS);
      this.ticks = ticks;
      this.sideMm = sideMm;
      endpoint = gvh.comms.open(CHANNEL, (from, at) -> heard(at));
    }

    @Override
    protected boolean step() {
      tick++;
      if (gvh.gps.hasFix()) {
        Pose pose = gvh.gps.pose();
        xMm = pose.xMm();
        yMm = pose.yMm();
        headingRad = pose.headingRad();
        turnFromEdges();
        gvh.plat.moat.doDrive(next);
        next = STRAIGHT;
        endpoint.broadcast(pose.at());
      }
      return tick < ticks;
    }

    private void turnFromEdges() {
      double x = xMm < NEAR_MM ? -1 : xMm > sideMm - NEAR_MM ? 1 : 0;
      double y = yMm < NEAR_MM ? -1 : yMm > sideMm - NEAR_MM ? 1 : 0;
      if (x != 0 || y != 0) {
        avoid(x, y);
      }
    }

    private void heard(Point at) {
      heard++;
      double x = at.xMm() - xMm;
      double y = at.yMm() - yMm;
      if (x * x + y * y < NEAR_MM * NEAR_MM) {
        avoid(x, y);
      }
    }

    /** Turns away from what is in direction (x, y), if it is ahead. */
    private void avoid(double x, double y) {
      double bearingRad = Angles.difference(StrictMath.atan2(y, x), headingRad);
      if (Math.abs(bearingRad) < StrictMath.PI / 2) {
        next = bearingRad > 0 ? RIGHT : LEFT;
      }
    }

    @Override
    protected List<Object> returnResults() {
      return List.of(heard);
    }
  }

  /** Drives straight on; turns for up to 2 s after a bump, away from the side that was hit. */
  private static final class Disc extends LogicThread {
    private static final int MOST_TURN_TICKS = 20;

    private final long ticks;
    private final Rng rng;
    private long tick;
    private long turnUntil;
    private long bumped;
    private WheelCommand turn = LEFT;

    Disc(GlobalVarHolder gvh, long ticks) {
      super(gvh, TICK_MS);
      this.ticks = ticks;
      rng = gvh.plat.entropy.fork("swarm");
    }

    @Override
    protected boolean step() {
      tick++;
      Bumps bumps = gvh.plat.moat.bumps();
      if (bumps.any()) {
        bumped++;
        turn = bumps == Bumps.LEFT ? RIGHT : LEFT;
        turnUntil = tick + 1 + rng.nextInt(MOST_TURN_TICKS);
      }
      gvh.plat.moat.doDrive(tick < turnUntil ? turn : STRAIGHT);
      return tick < ticks;
    }

    @Override
    protected List<Object> returnResults() {
      return List.of(bumped);
    }
  }
}
