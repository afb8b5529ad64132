package org.starl.shape;

import static org.starl.shape.Shapes.part;

import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;

/** Records with a part of each kind. */
public sealed interface Sample {

  enum Colour {
    RED,
    GREEN
  }

  /** Its x is at most its y, as its constructor requires. */
  record Span(int x, int y) {
    static final RecordShape<Span> SHAPE =
        Shapes.of(
            Span.class, part("x", Shapes.INT, Span::x), part("y", Shapes.INT, Span::y), Span::new);

    public Span {
      if (x > y) {
        throw new IllegalArgumentException("x " + x + " after y " + y);
      }
    }
  }

  record Place(double xMm, double yMm) {
    static final RecordShape<Place> SHAPE =
        Shapes.of(
            Place.class,
            part("xMm", Shapes.REAL, Place::xMm),
            part("yMm", Shapes.REAL, Place::yMm),
            Place::new);
  }

  record Nothing() implements Sample {}

  record Numbers(int small, int medium, int number, long large, double real, boolean isSo)
      implements Sample {}

  record Names(String text, RobotId robot, ProcessId process, Colour colour, Place place)
      implements Sample {}

  record Several(
      List<String> list,
      SortedSet<Long> set,
      SortedMap<RobotId, List<String>> map,
      Optional<String> text,
      Optional<Sample> inner)
      implements Sample {}

  RecordShape<Nothing> NOTHING = Shapes.of(Nothing.class, Nothing::new);

  RecordShape<Numbers> NUMBERS =
      Shapes.of(
          Numbers.class,
          part("small", Shapes.U8, Numbers::small),
          part("medium", Shapes.U16, Numbers::medium),
          part("number", Shapes.INT, Numbers::number),
          part("large", Shapes.LONG, Numbers::large),
          part("real", Shapes.REAL, Numbers::real),
          part("isSo", Shapes.BOOL, Numbers::isSo),
          Numbers::new);

  RecordShape<Names> NAMES =
      Shapes.of(
              Names.class,
              part("text", Shapes.TEXT, Names::text),
              part("robot", Shapes.ROBOT, Names::robot),
              part("process", Shapes.PROCESS, Names::process),
              part("colour", Shapes.constant(Colour.class), Names::colour),
              part("place", Place.SHAPE, Names::place),
              Names::new)
          .named("do_name");

  /** The shape of what a {@link Several} may have inside. */
  SumShape<Sample> INNER = Shapes.oneOf(Sample.class, NUMBERS, NAMES);

  RecordShape<Several> SEVERAL =
      Shapes.of(
          Several.class,
          part("list", Shapes.list(Shapes.TEXT, 0xFF), Several::list),
          part("set", Shapes.set(Shapes.LONG, 0xFFFF), Several::set),
          part("map", Shapes.map(Shapes.ROBOT, Shapes.list(Shapes.TEXT, 9), 0xFF), Several::map),
          part("text", Shapes.optional(Shapes.TEXT), Several::text),
          part("inner", Shapes.optional(INNER), Several::inner),
          Several::new);

  SumShape<Sample> SHAPE = Shapes.oneOf(Sample.class, NOTHING, NUMBERS, NAMES, SEVERAL);
}
