package org.starl.primitives.paths;

import static org.starl.shape.Shapes.part;

import java.util.List;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** The value of the variable {@code held}: the tubes of one robot. */
public record TubeList(List<Tube> tubes) {

  /** Its shape. */
  public static final Shape<TubeList> SHAPE =
      Shapes.of(
          TubeList.class,
          part("tubes", Shapes.list(Tube.SHAPE, Holding.MAX_TUBES), TubeList::tubes),
          TubeList::new);

  public TubeList {
    tubes = List.copyOf(tubes);
  }

  @Override
  public String toString() {
    return Tube.text(tubes);
  }
}
