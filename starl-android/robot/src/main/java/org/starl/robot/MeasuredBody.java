package org.starl.robot;

import static org.starl.time.Time.NS_PER_MS;

import java.util.SortedMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Fix;
import org.starl.id.RobotId;
import org.starl.platform.Clock;
import org.starl.platform.Positioning;
import org.starl.shape.RecordShape;
import org.starl.shape.Shapes;
import org.starl.time.Time;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceSink;
import org.starl.trace.Vocabulary;

/**
 * Passes a robot's fixes on and writes them into its trace as events of its body: in the trace the
 * body stands at its measured position until the next fix. A fact {@code positions within} has the
 * largest distance in mm between the true body and that position so far: the measurement's error plus
 * the path that the wheels can have driven since (bounded, because the wheels are stopped below the
 * program when fixes stop). It does not cover a body that is pushed or slides: a fact {@code
 * positions lost} has the time, in ms, for which that could have gone unseen. Strand only.
 */
public final class MeasuredBody implements Positioning {

  /** The body was at most so far from its place in the trace. */
  public record Within(long mm) {

    /** Its shape. */
    public static final RecordShape<Within> SHAPE =
        Shapes.of(Within.class, Shapes.part("mm", Shapes.LONG, Within::mm), Within::new)
            .named("within");
  }

  /** No measurement came for so long. */
  public record Lost(long ms) {

    /** Its shape. */
    public static final RecordShape<Lost> SHAPE =
        Shapes.of(Lost.class, Shapes.part("ms", Shapes.LONG, Lost::ms), Lost::new).named("lost");
  }

  /** The instance in the trace. */
  public static final Instance SOURCE = Instance.of("positions");

  /** What a reader of traces needs. */
  static final Vocabulary VOCABULARY =
      Vocabulary.NONE.facts(SOURCE.primitive(), Within.SHAPE, Lost.SHAPE);

  /** At 300 mm/s a body goes 6 mm in it; a fix that comes earlier is not written. */
  private static final long EVERY_NS = 20 * NS_PER_MS;

  private final RobotId id;
  private final double radiusMm;
  private final double mostMmPerS;
  private final long stillAfterNs;
  private final Positioning positioning;
  private final Supplier<SortedMap<RobotId, Fix>> newest;
  private final Clock clock;
  private final TraceSink trace;
  private @Nullable Fix last;
  private long lastAtNs;
  private long recordedMm = -1;

  /**
   * @param mostMmPerS greatest speed of the body by its wheels
   * @param stillAfterNs time from the last fix until the wheels stand still
   * @param newest the newest fixes of all robots, with times on the fixes' clock
   * @param clock the fixes' clock
   */
  MeasuredBody(
      RobotId id,
      double radiusMm,
      double mostMmPerS,
      long stillAfterNs,
      Positioning positioning,
      Supplier<SortedMap<RobotId, Fix>> newest,
      Clock clock,
      TraceSink trace) {
    this.id = id;
    this.radiusMm = radiusMm;
    this.mostMmPerS = mostMmPerS;
    this.stillAfterNs = stillAfterNs;
    this.positioning = positioning;
    this.newest = newest;
    this.clock = clock;
    this.trace = trace;
  }

  @Override
  public void onFix(Receiver receiver) {
    positioning.onFix(fix -> {
      long nowNs = clock.nowNs();
      if (trace.isOn() && (last == null || nowNs - lastAtNs >= EVERY_NS)) {
        write(fix, nowNs);
      }
      receiver.fixed(fix);
    });
  }

  @Override
  public SortedMap<RobotId, Fix> newest() {
    return newest.get();
  }

  /** Ends the fixes: records how far the body may have moved since the last one. */
  void end(long nowNs) {
    if (last != null) {
      recordBounds(last, nowNs);
    }
  }

  private void write(Fix fix, long nowNs) {
    if (last == null) {
      recordBounds(fix, nowNs);
      trace.record(new Joined(nowNs, id, fix.pose(), radiusMm));
    } else {
      recordBounds(last, nowNs);
      recordBounds(fix, nowNs);
      trace.record(new Moved(nowNs, id, fix.pose(), 0, 0));
    }
    last = fix;
    lastAtNs = nowNs;
  }

  /** Records the bounds of the body's position, which was {@code fix} in the trace until now. */
  private void recordBounds(Fix fix, long nowNs) {
    long ageNs = Math.max(0, nowNs - fix.timeNs());
    if (ageNs > stillAfterNs) {
      record(nowNs, Lost.SHAPE, new Lost(ageNs / NS_PER_MS));
    }
    double offMm = fix.errorMm() + mostMmPerS * Time.seconds(Math.min(ageNs, stillAfterNs));
    if (offMm > recordedMm) {
      recordedMm = (long) Math.ceil(offMm);
      record(nowNs, Within.SHAPE, new Within(recordedMm));
    }
  }

  private <F> void record(long nowNs, RecordShape<F> shape, F fact) {
    trace.record(Action.of(nowNs, id, SOURCE, shape, fact));
  }
}
