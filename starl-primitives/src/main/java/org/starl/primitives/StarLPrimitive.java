package org.starl.primitives;

import org.starl.trace.Instance;

/** One instance of a primitive on one robot. Strand only. */
public interface StarLPrimitive {

  /** The primitive and its instance, as on the wire and in the trace: {@code mutex/crossing}. */
  Instance source();

  /** Ends this robot's part: it receives and sends nothing more. */
  void close();
}
