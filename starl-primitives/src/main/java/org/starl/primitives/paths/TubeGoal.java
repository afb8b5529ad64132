package org.starl.primitives.paths;

import static org.starl.shape.Shapes.part;

import org.starl.geometry.ItemPosition;
import org.starl.shape.Geometry;
import org.starl.shape.Shape;
import org.starl.shape.Shapes;

/** Where a robot is told to go. */
public sealed interface TubeGoal {

  /** To a place. */
  record Place(ItemPosition item) implements TubeGoal {
    @Override
    public String toString() {
      return item.toString();
    }
  }

  /** Along a path. */
  record Along(Path path) implements TubeGoal {
    @Override
    public String toString() {
      return path.toString();
    }
  }

  /** Its shape. */
  Shape<TubeGoal> SHAPE =
      Shapes.oneOf(
          TubeGoal.class,
          Shapes.of(Place.class, part("item", Geometry.ITEM, Place::item), Place::new),
          Shapes.of(Along.class, part("path", Path.SHAPE, Along::path), Along::new));
}
