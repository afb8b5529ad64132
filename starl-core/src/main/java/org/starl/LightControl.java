package org.starl;

import org.jspecify.annotations.Nullable;
import org.starl.gvh.GvhCell;
import org.starl.gvh.Variables;
import org.starl.platform.Light;
import org.starl.trace.Instance;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/**
 * {@code gvh.plat.light}: the robot's light. From its first use its colour is the gvh variable {@code
 * light.colour}, which the trace records and the viewer shows. Strand only.
 */
public final class LightControl {

  /** The instance in the trace. */
  public static final Instance SOURCE = Instance.of("light");

  /** The light's colour. */
  public static final Var<LightColour> COLOUR = Var.of("colour", LightColour.SHAPE);

  /** What a reader of traces needs. */
  static final Vocabulary VOCABULARY = Vocabulary.NONE.variables(SOURCE.primitive(), COLOUR);

  private final Light light;
  private final Variables variables;
  private @Nullable GvhCell<LightColour> colour;

  LightControl(Light light, Variables variables) {
    this.light = light;
    this.variables = variables;
  }

  /**
   * Shows a colour until the next call.
   *
   * @param rgb from 0, which is off, to {@link Light#MAX_RGB}, red first
   */
  public void show(int rgb) {
    if (rgb < 0 || rgb > Light.MAX_RGB) {
      throw new IllegalArgumentException("colour " + rgb + ": expected 0 to 0xFFFFFF");
    }
    GvhCell<LightColour> cell = colour;
    if (cell == null) {
      cell = variables.variable(SOURCE, COLOUR, LightColour.OFF);
      colour = cell;
    }
    cell.set(new LightColour(rgb));
    light.show(rgb);
  }

  public void off() {
    show(0);
  }
}
