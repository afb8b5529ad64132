package org.starl.sim.fault;

import static org.starl.shape.Shapes.LONG;
import static org.starl.shape.Shapes.REAL;
import static org.starl.shape.Shapes.part;

import java.util.ArrayList;
import java.util.List;
import org.starl.GlobalVarHolder;
import org.starl.LogicThread;
import org.starl.comms.Channel;
import org.starl.comms.Codec;
import org.starl.comms.Endpoint;
import org.starl.geometry.ItemPosition;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.motion.Gps;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.sim.RobotSpec;
import org.starl.sim.SimObserver;
import org.starl.sim.SimSettings;
import org.starl.sim.Simulation;
import org.starl.spec.Bodies;
import org.starl.trace.TraceEvent;

/** Three robots in a row that beat ten times a second for 10 s, with faults; what is seen of it. */
final class ProbeRun {

  static final long MS = 1_000_000;
  static final long S = 1_000 * MS;

  private static final Channel<Long> BEATS =
      new Channel<>(
          "test",
          "beats",
          new Codec<>() {
            @Override
            public void write(Long message, WireWriter out) {
              out.i64(message);
            }

            @Override
            public Long read(WireReader in) {
              return in.i64();
            }
          });

  /** What a robot's clock shows. */
  record Clock(long shownNs) {
    static final RecordShape<Clock> SHAPE =
        Shapes.of(Clock.class, part("shownNs", LONG, Clock::shownNs), Clock::new);
  }

  /** A robot's latest fix. */
  record Fix(double xMm, double yMm, double errorMm, long ageNs, long contradictions) {
    static final RecordShape<Fix> SHAPE =
        Shapes.of(
            Fix.class,
            part("xMm", REAL, Fix::xMm),
            part("yMm", REAL, Fix::yMm),
            part("errorMm", REAL, Fix::errorMm),
            part("ageNs", LONG, Fix::ageNs),
            part("contradictions", LONG, Fix::contradictions),
            Fix::new);
  }

  /** A write to stable storage is done. */
  record Flushed() {
    static final RecordShape<Flushed> SHAPE = Shapes.of(Flushed.class, Flushed::new);
  }

  /** Sends beats and traces its clock and its fixes; bot0 drives along x meanwhile. */
  private static final class Probe extends LogicThread {

    Probe(GlobalVarHolder gvh) {
      super(gvh);
    }

    @Override
    public List<Object> callStarL() {
      Endpoint<Long> beats = gvh.comms.open(BEATS, (from, beat) -> {});
      await(gvh.gps::hasFix, 1000);
      if (gvh.id.name().name().equals("bot0")) {
        gvh.plat.moat.doMove(new ItemPosition("far", 100_000, 0));
      }
      for (long beat = 0; beat < 100; beat++) {
        beats.broadcast(beat);
        gvh.trace.action(Clock.SHAPE, new Clock(gvh.plat.clock.nowNs()));
        if (gvh.gps.hasFix()) {
          Pose pose = gvh.gps.pose();
          Gps gps = gvh.gps;
          gvh.trace.action(
              Fix.SHAPE,
              new Fix(pose.xMm(), pose.yMm(), gps.errorMm(), gps.ageNs(), gps.contradictions()));
        }
        gvh.plat.stable.put("beat", new byte[1], this::flushed);
        sleep(100);
      }
      return List.of();
    }

    private void flushed() {
      gvh.trace.action(Flushed.SHAPE, new Flushed());
    }
  }

  /** A fact of a robot's app, at its true time. */
  record Said<F>(long timeNs, F fact) {}

  final List<TraceEvent> events = new ArrayList<>();

  static Simulation.Builder simulation(long seed, String... faults) {
    return simulation(seed, false, faults);
  }

  private static Simulation.Builder simulation(long seed, boolean sealed, String... faults) {
    Simulation.Builder builder =
        Simulation.builder()
            .name("probe")
            .seed(seed)
            .settings(
                SimSettings.builder()
                    .set("messageDelay", "10ms")
                    .set("duration", "12s")
                    .set("sealed", sealed ? "yes" : "no")
                    .build());
    for (int i = 0; i < 3; i++) {
      builder.robot(new RobotSpec(id(i), new Pose(0, 1000 * i, 0), true, Probe::new));
    }
    for (String fault : faults) {
      builder.fault(fault);
    }
    return builder;
  }

  static ProbeRun of(String... faults) {
    return of(simulation(1, faults));
  }

  /** With a key that the robots share. */
  static ProbeRun sealed(String... faults) {
    return of(simulation(1, true, faults));
  }

  static ProbeRun of(Obstacles obstacles, String... faults) {
    return of(simulation(1, faults).obstacles(obstacles));
  }

  static ProbeRun of(Simulation.Builder builder) {
    ProbeRun run = new ProbeRun();
    builder
        .observer(
            new SimObserver() {
              @Override
              public void observed(TraceEvent event) {
                run.events.add(event);
              }
            })
        .build()
        .run();
    return run;
  }

  static RobotId id(int robot) {
    return new RobotId("bot" + robot);
  }

  /** Beats of one that reached another in a time of the run. */
  List<TraceEvent.Delivered> heard(int from, int to, long fromNs, long untilNs) {
    return of(TraceEvent.Delivered.class, to, fromNs, untilNs).stream()
        .filter(event -> event.from().equals(id(from)))
        .toList();
  }

  int count(int from, int to, long fromNs, long untilNs) {
    return heard(from, to, fromNs, untilNs).size();
  }

  <T extends TraceEvent> List<T> of(Class<T> kind, int robot, long fromNs, long untilNs) {
    return events.stream()
        .filter(kind::isInstance)
        .filter(event -> event.robot().equals(id(robot)))
        .filter(event -> event.timeNs() >= fromNs && event.timeNs() < untilNs)
        .map(kind::cast)
        .toList();
  }

  /** The facts of this type. */
  <F> List<Said<F>> said(int robot, Class<F> type, long fromNs, long untilNs) {
    return of(TraceEvent.Action.class, robot, fromNs, untilNs).stream()
        .filter(action -> type.isInstance(action.fact()))
        .map(action -> new Said<>(action.timeNs(), type.cast(action.fact())))
        .toList();
  }

  /** The faults in the trace: {@code ms robot name detail}. */
  List<String> faults() {
    List<String> lines = new ArrayList<>();
    for (TraceEvent event : events) {
      if (event instanceof TraceEvent.Fault fault) {
        String line = fault.timeNs() / MS + " " + fault.robot() + " " + fault.name();
        lines.add((line + " " + fault.detail()).strip());
      }
    }
    return lines;
  }

  /** The true x position of bot0 at a time. */
  double bot0XMm(long atNs) {
    Bodies bodies = new Bodies();
    events.stream().filter(event -> event.timeNs() <= atNs).forEach(bodies::observe);
    return bodies.poseAt(id(0), atNs).xMm();
  }
}
