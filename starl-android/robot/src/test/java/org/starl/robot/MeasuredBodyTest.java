package org.starl.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Fix;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.platform.Positioning;
import org.starl.robot.MeasuredBody.Lost;
import org.starl.robot.MeasuredBody.Within;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Joined;
import org.starl.trace.TraceEvent.Moved;
import org.starl.trace.TraceSink;

/** What a robot writes of its own body, and how far it may be from the truth. */
class MeasuredBodyTest {

  private static final RobotId SELF = new RobotId("bot0");
  private static final long MS = 1_000_000;
  private static final double MOST_MM_PER_S = 300;
  private static final long STILL_AFTER_MS = 400;

  private final List<TraceEvent> trace = new ArrayList<>();
  private final List<Fix> heard = new ArrayList<>();
  private long nowNs;
  private Positioning.Receiver cameras = fix -> {};

  private final MeasuredBody body =
      new MeasuredBody(
          SELF,
          165,
          MOST_MM_PER_S,
          STILL_AFTER_MS * MS,
          receiver -> cameras = receiver,
          Collections::emptySortedMap,
          () -> nowNs,
          new TraceSink() {
            @Override
            public boolean isOn() {
              return true;
            }

            @Override
            public void record(TraceEvent event) {
              trace.add(event);
            }
          });

  MeasuredBodyTest() {
    body.onFix(heard::add);
  }

  /** A fix comes, so late. */
  private void fix(long atMs, long lateMs, double xMm, double errorMm) {
    nowNs = atMs * MS;
    cameras.fixed(new Fix(pose(xMm), nowNs - lateMs * MS, errorMm, 0.01));
  }

  private static Pose pose(double xMm) {
    return new Pose(xMm, 0, 0);
  }

  private <F> Stream<F> facts(Class<F> type) {
    return trace.stream()
        .flatMap(event -> event instanceof Action action ? Stream.of(action.fact()) : Stream.of())
        .filter(type::isInstance)
        .map(type::cast);
  }

  private long withinMm() {
    return facts(Within.class).mapToLong(Within::mm).max().orElse(0);
  }

  @Test
  void theFirstFixPlacesTheBodyAndLaterFixesMoveIt() {
    fix(100, 0, 1, 5);
    fix(120, 0, 2, 5);
    fix(140, 0, 3, 5);

    assertThat(trace)
        .filteredOn(event -> !(event instanceof Action))
        .containsExactly(
            new Joined(100 * MS, SELF, pose(1), 165),
            new Moved(120 * MS, SELF, pose(2), 0, 0),
            new Moved(140 * MS, SELF, pose(3), 0, 0));
  }

  @Test
  void fixesInQuickSuccessionAreNotAllTraced() {
    for (int ms = 0; ms < 100; ms += 5) {
      fix(ms, 0, ms, 5);
    }

    assertThat(heard).hasSize(20);
    assertThat(trace).filteredOn(event -> event instanceof Moved).hasSize(4);
  }

  @Test
  void theBoundIsTheErrorPlusThePossibleWayUntilTheNextFix() {
    fix(100, 10, 0, 5);
    assertThat(withinMm()).isEqualTo(5 + 3);

    // Its place at 90 ms is what the trace has until 150 ms.
    fix(150, 0, 10, 5);
    assertThat(withinMm()).isEqualTo(5 + 18);

    fix(170, 0, 10, 5);
    assertThat(withinMm()).isEqualTo(5 + 18);
  }

  @Test
  void aLessAccurateMeasurementIsTraced() {
    fix(100, 0, 0, 5);
    fix(120, 0, 0, 40);

    assertThat(withinMm()).isEqualTo(40);
  }

  private List<Long> lostMs() {
    return facts(Lost.class).map(Lost::ms).toList();
  }

  @Test
  void theBodyMayMoveUntilTheEnd() {
    fix(100, 0, 0, 5);
    body.end(150 * MS);

    assertThat(withinMm()).isEqualTo(5 + 15);
    assertThat(lostMs()).isEmpty();
  }

  @Test
  void theBodyMayMoveWhileItsWheelsTurn() {
    fix(100, 0, 0, 5);
    fix(450, 50, 90, 5);

    assertThat(withinMm()).isEqualTo(5 + 105);
    assertThat(lostMs()).isEmpty();
  }

  @Test
  void aBodyWithoutFixesForLongIsLostWhereItWas() {
    fix(100, 0, 0, 5);
    fix(600, 0, 0, 5);
    fix(620, 0, 0, 5);
    body.end(1_200 * MS);

    assertThat(withinMm()).isEqualTo(5 + 120);
    assertThat(lostMs()).containsExactly(500L, 580L);
  }

  @Test
  void aRobotWithoutAnyFixHasNoBody() {
    body.end(600 * MS);

    assertThat(trace).isEmpty();
  }
}
