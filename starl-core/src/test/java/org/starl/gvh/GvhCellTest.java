package org.starl.gvh;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;
import org.starl.trace.Var;

class GvhCellTest {

  private static final RobotId ROBOT = new RobotId("bot0");

  private static final Instance MUTEX = Instance.of("mutex", "crossing");
  private static final Var<Boolean> CRIT = Var.of("crit", Shapes.BOOL);

  private final List<TraceEvent> events = new ArrayList<>();
  private long nowNs;

  private final TraceSink sink =
      new TraceSink() {
        @Override
        public boolean isOn() {
          return true;
        }

        @Override
        public void record(TraceEvent event) {
          events.add(event);
        }
      };

  private final GvhCell<Boolean> crit =
      new GvhCell<>(new Trace(ROBOT, () -> nowNs, sink), MUTEX, CRIT, false);

  private static TraceEvent variable(long timeNs, boolean value) {
    return new TraceEvent.Variable(timeNs, ROBOT, MUTEX, CRIT, value);
  }

  @Test
  void theFirstValueIsTraced() {
    assertThat(crit.get()).isFalse();
    assertThat(events).containsExactly(variable(0, false));
  }

  @Test
  void onlyChangesAreTraced() {
    nowNs = 5;
    crit.set(true);
    nowNs = 6;
    crit.set(true);
    nowNs = 7;
    crit.set(false);
    assertThat(events).containsExactly(variable(0, false), variable(5, true), variable(7, false));
  }

  @Test
  void readersSeeTheNewestValueAndItsSource() {
    GvhVariable<Boolean> reader = crit.variable();
    crit.set(true);
    assertThat(reader.get()).isTrue();
    assertThat(reader.source()).isEqualTo(MUTEX);
    assertThat(reader.name()).isEqualTo("crit");
  }
}
