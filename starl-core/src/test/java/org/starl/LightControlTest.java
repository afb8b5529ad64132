package org.starl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Trace;
import org.starl.gvh.Variables;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceSink;

class LightControlTest {

  private final List<Integer> shown = new ArrayList<>();
  private final Variables variables =
      new Variables(
          new Trace(
              new RobotId("bot0"),
              () -> 0,
              new TraceSink() {
                @Override
                public boolean isOn() {
                  return false;
                }

                @Override
                public void record(TraceEvent event) {}
              }));
  private final LightControl light = new LightControl(shown::add, variables);

  @Test
  void theColourIsAVariableFromTheFirstUse() {
    assertThat(variables.all()).isEmpty();
    light.show(0xFF8800);
    GvhVariable<?> colour = variables.all().get(0);
    assertThat(colour.source() + "." + colour.name()).isEqualTo("light.colour");
    assertThat(colour.get()).isEqualTo(new LightColour(0xFF8800)).hasToString("#ff8800");
    light.off();
    assertThat(colour.get()).isEqualTo(LightColour.OFF).hasToString("off");
    assertThat(shown).containsExactly(0xFF8800, 0);
  }

  @Test
  void aColourOfMoreThan24BitsIsRefused() {
    assertThatThrownBy(() -> light.show(0x1000000)).isInstanceOf(IllegalArgumentException.class);
    assertThatThrownBy(() -> light.show(-1)).isInstanceOf(IllegalArgumentException.class);
    assertThat(shown).isEmpty();
  }
}
