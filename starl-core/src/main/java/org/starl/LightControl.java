package org.starl;

import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.starl.gvh.GvhCell;
import org.starl.gvh.Variables;
import org.starl.platform.Light;

/**
 * {@code gvh.plat.light}: the robot's light. From its first use its colour is the gvh variable {@code
 * light.colour}, which the trace records and the viewer shows. Strand only.
 */
public final class LightControl {

  /** The variable's source. */
  public static final String SOURCE = "light";

  /** The variable's name. */
  public static final String COLOUR = "colour";

  /** The variable's value while the light is off; else {@code #ff8800}. */
  public static final String OFF = "off";

  private final Light light;
  private final Variables variables;
  private @Nullable GvhCell<String> colour;

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
    GvhCell<String> cell = colour;
    if (cell == null) {
      cell = variables.variable(SOURCE, COLOUR, OFF);
      colour = cell;
    }
    cell.set(rgb == 0 ? OFF : String.format(Locale.ROOT, "#%06x", rgb));
    light.show(rgb);
  }

  public void off() {
    show(0);
  }
}
