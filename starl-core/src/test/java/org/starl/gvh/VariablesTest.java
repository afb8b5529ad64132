package org.starl.gvh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;
import org.starl.trace.Var;

/** A variable has one writer, and everyone else can only read it. */
class VariablesTest {

  private static final Instance CROSSING = Instance.of("mutex", "crossing");
  private static final Var<Boolean> CRIT = Var.of("crit", Shapes.BOOL);
  private static final Var<Integer> OTHER_CRIT = Var.of("crit", Shapes.INT);

  private final List<TraceEvent> events = new ArrayList<>();
  private final Variables variables =
      new Variables(
          new Trace(
              new RobotId("bot0"),
              () -> 0,
              new TraceSink() {
                @Override
                public boolean isOn() {
                  return true;
                }

                @Override
                public void record(TraceEvent event) {
                  events.add(event);
                }
              }));

  @Test
  void aSecondWriterOfOneVariableIsRefusedWithBothPlaces() {
    variables.variable(CROSSING, CRIT, false);
    assertThat(CRIT.place()).contains("VariablesTest.java:");
    assertThat(OTHER_CRIT.place()).contains("VariablesTest.java:").isNotEqualTo(CRIT.place());

    assertThatIllegalStateException()
        .isThrownBy(() -> variables.variable(CROSSING, OTHER_CRIT, 1))
        .withMessageContaining("mutex/crossing.crit")
        .withMessageContaining(CRIT.place())
        .withMessageContaining(OTHER_CRIT.place());
    assertThatIllegalStateException()
        .isThrownBy(() -> variables.variable(Instance.named("mutex/crossing"), CRIT, true));
    assertThat(variables.all()).hasSize(1);
    assertThat(events).hasSize(1);
  }

  @Test
  void eachInstanceHasItsOwnVariable() {
    GvhCell<Boolean> one = variables.variable(CROSSING, CRIT, false);
    GvhCell<Boolean> other = variables.variable(Instance.of("mutex", "dock"), CRIT, false);
    other.set(true);
    assertThat(one.get()).isFalse();
    assertThat(variables.all()).containsExactly(one.variable(), other.variable());
  }

  @Test
  void whatIsPublishedCannotBeWritten() {
    GvhCell<Boolean> cell = variables.variable(CROSSING, CRIT, false);
    GvhVariable<Boolean> published = cell.variable();
    assertThat((Object) published).isNotInstanceOf(GvhCell.class);
    assertThat((Object) cell).isNotInstanceOf(GvhVariable.class);
    cell.set(true);
    assertThat(published.get()).isTrue();
    assertThat(published).hasToString("mutex/crossing.crit=true");
  }
}
