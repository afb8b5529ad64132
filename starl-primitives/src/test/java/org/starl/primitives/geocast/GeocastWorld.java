package org.starl.primitives.geocast;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import org.starl.geometry.Everywhere;
import org.starl.geometry.Kinematics;
import org.starl.geometry.Point;
import org.starl.geometry.Pose;
import org.starl.geometry.Region;
import org.starl.id.Participants;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.random.Rng;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;
import org.starl.spec.Monitors;
import org.starl.spec.SpecReport;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;

/**
 * Robots on a floor that send geocasts over a network with loss, delay, duplication and reordering.
 * Positions and clocks have errors within their bounds. A {@link GeocastSpec} and a {@link
 * GeocastConformance} check the trace.
 */
final class GeocastWorld {

  static final long MS = 1_000_000;

  /** Planted bugs, which the specification must find. */
  enum Mutant {
    NONE,
    IGNORES_AREA,
    IGNORES_DEADLINE,
    DELIVERS_TWICE,
    NEVER_DELIVERS
  }

  private record Event(long timeNs, long order, Runnable action) {}

  private final PriorityQueue<Event> events =
      new PriorityQueue<>(Comparator.comparingLong(Event::timeNs).thenComparingLong(Event::order));
  private final Rng rng;
  private final Mutant mutant;
  private final double errorMm;
  private final long skewNs;
  private final Map<RobotId, Robot> robots = new LinkedHashMap<>();
  private final Monitors monitors;
  private long nowNs;
  private long order;
  private double loss;
  private double duplication;
  private long maxDelayNs = 10 * MS;

  GeocastWorld(long seed, int robotCount, double errorMm, long skewNs, Mutant mutant) {
    this.rng = new Rng(seed);
    this.mutant = mutant;
    this.errorMm = errorMm;
    this.skewNs = skewNs;
    GeocastSettings settings = new GeocastSettings(100, 1_000, skewNs, false);
    this.monitors =
        new Monitors(List.of(new GeocastSpec(errorMm, settings), new GeocastConformance()));
    List<RobotId> ids = new ArrayList<>();
    for (int i = 0; i < robotCount; i++) {
      ids.add(new RobotId("bot" + i));
    }
    for (RobotId id : ids) {
      robots.put(id, new Robot(id, Participants.of(ids), settings));
    }
  }

  void network(double lossProbability, double duplicationProbability, long worstDelayNs) {
    loss = lossProbability;
    duplication = duplicationProbability;
    maxDelayNs = worstDelayNs;
  }

  Robot robot(int i) {
    return new ArrayList<>(robots.values()).get(i);
  }

  void at(long timeNs, Runnable action) {
    events.add(new Event(timeNs, order++, action));
  }

  SpecReport runUntil(long endNs) {
    while (!events.isEmpty() && events.element().timeNs() <= endNs) {
      Event next = events.remove();
      nowNs = next.timeNs();
      next.action().run();
    }
    monitors.finish(endNs);
    return monitors.report();
  }

  private void record(TraceEvent event) {
    monitors.observe(event);
  }

  final class Robot {
    final List<String> delivered = new ArrayList<>();
    int copiesSent;

    private final RobotId id;
    private final long clockErrorNs = skewNs == 0 ? 0 : rng.nextLong(0, skewNs);
    private final GeocastProtocol<String> protocol;
    private Pose from = new Pose(0, 0, 0);
    private double linearMmPerS;
    private double angularRadPerS;
    private long sinceNs;
    private long seq;

    private Robot(RobotId id, Participants deployment, GeocastSettings settings) {
      this.id = id;
      ProcessId me = ProcessId.first(id, 1);
      protocol = new GeocastProtocol<>(me, deployment, settings, new Port());
      tell(new GeocastFact.Opened(me));
    }

    void join(double xMm, double yMm) {
      from = new Pose(xMm, yMm, 0);
      record(new TraceEvent.Joined(nowNs, id, from, 165));
    }

    void drive(double headingRad, double linear, double angular) {
      Point at = truePoint();
      from = Pose.of(at, headingRad);
      sinceNs = nowNs;
      linearMmPerS = linear;
      angularRadPerS = angular;
      record(new TraceEvent.Moved(nowNs, id, from, linear, angular));
    }

    Point truePoint() {
      double seconds = (nowNs - sinceNs) / 1e9;
      return Kinematics.after(from, linearMmPerS, angularRadPerS, seconds).at();
    }

    GeocastReceipt geocast(String message, Region area, long dNs) {
      tell(new GeocastFact.do_geocast(protocol.nextId(), area, dNs));
      GeocastReceipt receipt = protocol.do_geocast(message, area, dNs, clockNs());
      rearm();
      return receipt;
    }

    boolean isComplete() {
      return protocol.isComplete();
    }

    private long clockNs() {
      return nowNs + clockErrorNs;
    }

    private void tell(GeocastFact fact) {
      record(TraceEvent.Action.of(nowNs, id, SOURCE, GeocastFact.SHAPE, fact));
    }

    private void rearm() {
      long wakeAtNs = protocol.wakeAtNs();
      if (wakeAtNs != Long.MAX_VALUE) {
        at(
            Math.max(nowNs, wakeAtNs - clockErrorNs),
            () -> {
              if (clockNs() >= protocol.wakeAtNs()) {
                protocol.timer(clockNs());
                rearm();
              }
            });
      }
    }

    private void send(Robot to, GeocastMessage<String> message, long seqOfCopy) {
      int copies = rng.nextBoolean(duplication) ? 2 : 1;
      for (int i = 0; i < copies; i++) {
        if (!rng.nextBoolean(loss)) {
          long delayNs = rng.nextLong(1, maxDelayNs);
          at(nowNs + delayNs, () -> to.received(id, message, seqOfCopy));
        }
      }
    }

    private void received(RobotId sender, GeocastMessage<String> message, long seqOfCopy) {
      record(new TraceEvent.Delivered(nowNs, id, sender, SOURCE, seqOfCopy, MESSAGE, message));
      GeocastMessage<String> seen = message;
      if (mutant == Mutant.IGNORES_DEADLINE
          && message instanceof GeocastMessage.Copy<String> copy) {
        seen =
            new GeocastMessage.Copy<>(
                copy.id(), copy.area(), copy.startNs(), Long.MAX_VALUE, copy.message());
      }
      protocol.received(sender, seen, clockNs());
      rearm();
    }

    private final class Port implements GeocastPort<String> {
      @Override
      public void broadcast(GeocastMessage.Copy<String> copy) {
        copiesSent++;
        tell(new GeocastFact.copy(copy.id()));
        seq++;
        record(new TraceEvent.Sent(nowNs, id, TraceEvent.Sent.ALL, SOURCE, seq, 1, MESSAGE, copy));
        for (Robot other : robots.values()) {
          if (other != Robot.this) {
            send(other, copy, seq);
          }
        }
      }

      @Override
      public void acknowledge(RobotId to, GeocastMessage.Ack<String> ack) {
        seq++;
        record(new TraceEvent.Sent(nowNs, id, to.name(), SOURCE, seq, 1, MESSAGE, ack));
        send(java.util.Objects.requireNonNull(robots.get(to)), ack, seq);
      }

      @Override
      public double surelyInsideMm(Region area) {
        if (area instanceof Everywhere) {
          return Double.POSITIVE_INFINITY;
        }
        double angle = 2 * StrictMath.PI * rng.nextDouble();
        double off = errorMm * rng.nextDouble();
        Point error = new Point(off * StrictMath.cos(angle), off * StrictMath.sin(angle));
        double inside = area.depthMm(truePoint().plus(error)) - errorMm;
        return mutant == Mutant.IGNORES_AREA ? 1 : inside;
      }

      @Override
      public void deliver(GeocastId geocast, String message) {
        if (mutant == Mutant.NEVER_DELIVERS) {
          return;
        }
        tell(new GeocastFact.deliver(geocast));
        delivered.add(message);
        if (mutant == Mutant.DELIVERS_TWICE) {
          tell(new GeocastFact.deliver(geocast));
        }
      }

      @Override
      public void dismissed(GeocastId geocast, Dismissal why) {
        tell(new GeocastFact.dismiss(geocast, why, errorMm));
      }
    }
  }

  private static final Instance SOURCE = Instance.of(GeocastFact.GEOCAST, "test");
  private static final Shape<GeocastMessage<String>> MESSAGE = GeocastMessage.shape(Shapes.TEXT);
}
