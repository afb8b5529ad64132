package org.starl.primitives;

/** One instance of a primitive on one robot. Strand only. */
public interface StarLPrimitive {

  /** The primitive and its instance, as on the wire and in the trace: {@code mutex/crossing}. */
  String source();

  /** Ends this robot's part: it receives and sends nothing more. */
  void close();
}
