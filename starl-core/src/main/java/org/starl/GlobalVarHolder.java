package org.starl;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.starl.comms.Comms;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Log;
import org.starl.gvh.Trace;
import org.starl.motion.Gps;
import org.starl.motion.MotionControl;
import org.starl.platform.Platform;

/**
 * The global variable holder {@code gvh} (paper, section 2 and Figure 1): the one object through
 * which an app and its primitives reach everything else of their robot. There is one class of it,
 * over whatever {@link Platform}: no simulated and no real one. Strand only.
 */
public final class GlobalVarHolder {

  public final Identity id;
  public final Comms comms;
  public final Gps gps;
  public final Plat plat;
  public final Log log;
  public final Trace trace;

  private final List<GvhVariable<?>> variables = new ArrayList<>();

  /**
   * @param boot how often this robot's program has started, from 1; no two gvh of a robot have the
   *     same
   */
  public GlobalVarHolder(Platform platform, int boot) {
    log = new Log(platform.clock(), platform.log());
    trace = new Trace(platform.id(), platform.clock(), platform.trace());
    id = new Identity(platform.id(), platform.deployment(), boot);
    comms = new Comms(platform, boot);
    gps = new Gps(this, platform);
    plat =
        new Plat(
            new MotionControl(this, platform, gps),
            platform.clock(),
            platform.timers(),
            platform.strand(),
            platform.stable(),
            platform.entropy(),
            platform.background());
  }

  /** A new variable of the gvh, and the right to write it. */
  public <T> GvhCell<T> variable(String source, String name, T initial) {
    GvhCell<T> cell = new GvhCell<>(trace, source, name, initial);
    variables.add(cell);
    return cell;
  }

  /**
   * For a primitive whose second instance would act under the same id without the memory of the
   * first: asks this before it makes its variables.
   *
   * @throws IllegalStateException if this start of the robot's program has had {@code source} already
   */
  public void requireFirst(String source) {
    for (GvhVariable<?> variable : variables) {
      if (variable.source().equals(source)) {
        throw new IllegalStateException(source + ": this robot has had this instance already");
      }
    }
  }

  /** Adds a variable whose owner computes its value when it is read. */
  public void register(GvhVariable<?> variable) {
    variables.add(variable);
  }

  /** Every variable of this robot, in the order in which they were made. */
  public List<GvhVariable<?>> variables() {
    return Collections.unmodifiableList(variables);
  }
}
