package org.starl.apps.lightpaint.logic;

import org.starl.primitives.geocast.GeocastFact;
import org.starl.primitives.geocast.GeocastMessage;
import org.starl.primitives.monitor.PrimitiveVocabulary;
import org.starl.shape.Shapes;
import org.starl.trace.Instance;
import org.starl.trace.Var;
import org.starl.trace.Vocabulary;

/** What a trace tells of a painter: its variables. */
public final class PaintFact {

  /** Where the program is. */
  public static final Var<Location> LOCATION = Var.of("location", Location.class);

  /** The light. */
  public static final Var<Light> LIGHT = Var.of("light", Light.SHAPE);

  /** The number of the stroke that the painter works on; -1 for none. */
  public static final Var<Integer> STROKE = Var.of("stroke", Shapes.INT);

  /** What a reader of traces needs. */
  public static final Vocabulary VOCABULARY =
      PrimitiveVocabulary.ALL
          .messages(GeocastFact.BROADCAST, GeocastMessage.shape(Hint.SHAPE))
          .variables(Instance.APP.primitive(), LOCATION, LIGHT, STROKE);

  private PaintFact() {}
}
