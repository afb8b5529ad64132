package org.starl;

import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.starl.gvh.Variables;
import org.starl.motion.MotionController;
import org.starl.platform.Background;
import org.starl.platform.Clock;
import org.starl.platform.Entropy;
import org.starl.platform.ObjectSensor;
import org.starl.platform.Platform;
import org.starl.platform.StableStorage;
import org.starl.platform.Strand;
import org.starl.platform.Timers;
import org.starl.shape.Shape;

/** {@code gvh.plat}: motion control, and the ports that primitives and apps use. */
public final class Plat {

  /** Motion control (paper, section 3.2): {@code gvh.plat.moat.doMove(p)}. */
  public final MotionController moat;

  public final Clock clock;
  public final Timers timers;
  public final Strand strand;
  public final StableStorage stable;
  public final Entropy entropy;

  /** The robot's sensor for objects that are no robots. */
  public final ObjectSensor objects;

  public final LightControl light;
  private final Background background;
  private final Set<String> persistent = new TreeSet<>();

  Plat(MotionController moat, Platform platform, Variables variables) {
    this.moat = moat;
    this.clock = platform.clock();
    this.timers = platform.timers();
    this.strand = platform.strand();
    this.stable = platform.stable();
    this.entropy = platform.entropy();
    this.objects = platform.objects();
    this.light = new LightControl(platform.light(), variables);
    this.background = platform.background();
  }

  /**
   * The variable that is stored under this name. It has the value that this robot's programs have set
   * last, as far as it was flushed, or {@code initial}.
   *
   * @param name of the variable on this robot; primitives begin theirs with their own name and a slash
   * @throws IllegalStateException if this program has this variable already, or if its stored bytes are
   *     none of {@code shape}
   */
  public <T> Persistent<T> persistent(String name, Shape<T> shape, T initial) {
    if (!persistent.add(name)) {
      throw new IllegalStateException(
          "stable storage: '" + name + "' is in use: expected one owner");
    }
    return new Persistent<>(stable, name, shape, initial);
  }

  /**
   * Computes off the strand: {@code var path = gvh.plat.compute(() -> planner.plan(task));
   * await(path::isDone);}. The task may read only immutable values that it was given; it must use
   * neither gvh nor primitives.
   */
  public <T> Computation<T> compute(Supplier<T> task) {
    return Computation.start(background, task);
  }
}
