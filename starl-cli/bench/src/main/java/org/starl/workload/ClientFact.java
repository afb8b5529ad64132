package org.starl.workload;

import static org.starl.shape.Shapes.INT;
import static org.starl.shape.Shapes.part;

import org.starl.shape.Shapes;
import org.starl.shape.SumShape;
import org.starl.trace.Instance;

/** What a trace tells of a {@link Client}. */
sealed interface ClientFact {

  /** The instance in the trace. */
  Instance SOURCE = Instance.of("workload");

  /** The robot makes a request. */
  record ask(int round) implements ClientFact {}

  /** The request succeeded. */
  record served(int round) implements ClientFact {}

  /** The request failed. */
  record told(int round) implements ClientFact {}

  /** A wait of {@code ofMs} ended so much too late by the robot's clock. */
  record late(long ms, long ofMs) implements ClientFact {}

  /** The shapes of all facts. */
  SumShape<ClientFact> SHAPE =
      Shapes.oneOf(
          ClientFact.class,
          Shapes.of(ask.class, part("round", INT, ask::round), ask::new),
          Shapes.of(served.class, part("round", INT, served::round), served::new),
          Shapes.of(told.class, part("round", INT, told::round), told::new),
          Shapes.of(
              late.class,
              part("ms", Shapes.LONG, late::ms),
              part("ofMs", Shapes.LONG, late::ofMs),
              late::new));
}
