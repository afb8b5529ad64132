package org.starl.spec;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Variable;

/**
 * A monitor of all instances of one primitive. It keeps one state for each instance, and passes each
 * event to the method for its kind. The source in the trace identifies the instance: {@code
 * mutex/crossing}.
 *
 * @param <R> the state kept for one instance
 */
public abstract class InstanceMonitor<R> extends LemmaMonitor {

  private Predicate<Instance> isInstance;
  private final Map<Instance, R> instances = new TreeMap<>();

  /**
   * @param kinds of its instances, as {@link Instance#kind} has them
   */
  protected InstanceMonitor(String... kinds) {
    List<String> known = List.of(kinds);
    isInstance = source -> known.contains(source.kind());
  }

  /**
   * Checks the instance {@code xid} only: {@code new MutexSpec(bounds).only("crossing")}. Its {@link
   * #companions} still check every instance.
   */
  public final InstanceMonitor<R> only(String xid) {
    isInstance = isInstance.and(source -> source.xid().equals(xid));
    return this;
  }

  /** The state of an instance before its first event. */
  protected abstract R begin(Instance source);

  /** The state of instance {@code source}, created at the first call. */
  protected final R instance(Instance source) {
    return instances.computeIfAbsent(source, this::begin);
  }

  /** All instances seen so far, in the order of their sources. */
  protected final Map<Instance, R> instances() {
    return instances;
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    if (!dispatch(event, report)) {
      happened(event, report);
    }
  }

  /** Hands an instance's action or variable on; returns whether {@code event} was one. */
  protected final boolean dispatch(TraceEvent event, Report report) {
    switch (event) {
      case Action action when isInstance.test(action.source()) -> acted(action, report);
      case Variable variable when isInstance.test(variable.source()) -> changed(variable, report);
      default -> {
        return false;
      }
    }
    return true;
  }

  /** Sees an action of an instance. */
  protected void acted(Action action, Report report) {}

  /** Sees a new value of an instance's variable. */
  protected void changed(Variable variable, Report report) {}

  /** Sees any other event. */
  protected void happened(TraceEvent event, Report report) {}
}
