package org.starl;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.starl.comms.Ack;
import org.starl.comms.Comms;
import org.starl.gvh.GvhCell;
import org.starl.gvh.GvhVariable;
import org.starl.gvh.Log;
import org.starl.gvh.Trace;
import org.starl.gvh.Variables;
import org.starl.gvh.Wait;
import org.starl.motion.Gps;
import org.starl.motion.MotionController;
import org.starl.motion.MotionFact;
import org.starl.platform.Platform;
import org.starl.trace.Instance;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/**
 * The global variable holder {@code gvh} (paper, section 2 and Figure 1): an app and its primitives
 * reach everything else of their robot through it. The same class serves the simulator and
 * hardware; only the {@link Platform} differs. Strand only.
 */
public final class GlobalVarHolder {

  /** What a reader of traces needs for what every robot has. */
  public static final Vocabulary VOCABULARY =
      MotionFact.VOCABULARY.and(LightControl.VOCABULARY).messages(Ack.CHANNEL, Ack.SHAPE);

  public final Identity id;
  public final Comms comms;
  public final Gps gps;
  public final Plat plat;
  public final Log log;
  public final Trace trace;

  private final Variables variables;
  private final Map<String, Object> published = new TreeMap<>();
  private final List<Supplier<@Nullable Wait>> waits = new ArrayList<>();

  /**
   * @param boot how often this robot's program has started, from 1; each start of a robot has its
   *     own
   */
  public GlobalVarHolder(Platform platform, int boot) {
    log = new Log(platform.clock(), platform.log());
    trace = new Trace(platform.id(), platform.clock(), platform.trace());
    variables = new Variables(trace);
    id =
        new Identity(
            platform.id(), platform.deployment(), boot, StorageEpoch.of(platform.stable()));
    comms = new Comms(platform, boot);
    gps = new Gps(platform, variables);
    plat =
        new Plat(new MotionController(platform, gps, log, trace, variables), platform, variables);
  }

  /**
   * Adds a variable of the app to the gvh. The returned cell is the only way to write it.
   *
   * @throws IllegalStateException if the app has a variable of this name already
   */
  public <T> GvhCell<T> variable(Var<T> declaration, T initial) {
    return variable(Instance.APP, declaration, initial);
  }

  /**
   * Adds a variable of a primitive to the gvh. The returned cell is the only way to write it.
   *
   * @throws IllegalStateException if {@code source} has a variable of this name already
   */
  public <T> GvhCell<T> variable(Instance source, Var<T> declaration, T initial) {
    return variables.variable(source, declaration, initial);
  }

  /**
   * For a primitive of which each start of a program may have one instance: a second one would act
   * under the same id without the memory of the first. Call it before creating variables.
   *
   * @throws IllegalStateException if {@code source} has variables already
   */
  public void requireFirstInstance(Instance source) {
    for (GvhVariable<?> variable : variables.all()) {
      if (variable.source().equals(source)) {
        throw new IllegalStateException(source + ": this robot has this instance already");
      }
    }
  }

  /**
   * Makes {@code part} known to later parts of this robot, which find it by {@link #published}.
   *
   * @param xid the instance; of two parts of one type and instance the later one counts
   */
  public <T> void publish(Class<T> type, String xid, T part) {
    published.put(type.getName() + "/" + xid, part);
  }

  /** The part of this type and instance that was published; null if none was. */
  public <T> @Nullable T published(Class<T> type, String xid) {
    return type.cast(published.get(type.getName() + "/" + xid));
  }

  /** Adds a variable whose owner computes its value when it is read. */
  public void register(GvhVariable<?> variable) {
    variables.register(variable);
  }

  /**
   * Adds a part of this robot that can say what it waits for or holds.
   *
   * @param wait returns null while it waits for nothing and holds nothing; has no effects
   */
  public void explain(Supplier<@Nullable Wait> wait) {
    waits.add(wait);
  }

  /** What the parts of this robot wait for or hold now, in the order of their creation. */
  public List<Wait> waits() {
    return waits.stream().map(Supplier::get).filter(Objects::nonNull).collect(Collectors.toList());
  }

  /** All variables of this robot, in the order of their creation. */
  public List<GvhVariable<?>> variables() {
    return variables.all();
  }
}
