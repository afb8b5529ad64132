package org.starl.primitives.agreement;

import java.util.function.Consumer;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;

/**
 * The shape of {@link SynodMessage}s on a channel whose owner accepts some values and wishes only. Its
 * bytes are in {@code docs/wire-format.md}.
 */
public final class SynodCodec {

  private SynodCodec() {}

  /**
   * @param format rejects malformed values and wishes, so that their datagrams are dropped on arrival
   */
  public static Shape<SynodMessage> of(Format format) {
    return SynodMessage.shape(Value.SHAPE, Value.SHAPE.where(refusing(format::checkWish)))
        .where(refusing(message -> check(format, message)));
  }

  private static void check(Format format, SynodMessage message) {
    switch (message) {
      case SynodMessage.Accept m -> format.checkValue(m.number(), m.value());
      case SynodMessage.Decided m -> format.checkValue(m.number(), m.value());
      case SynodMessage.Promise m when m.vote() != null ->
          format.checkValue(m.number(), m.vote().value());
      default -> {
        // has no value
      }
    }
  }

  /** The values and wishes that the owner of a channel accepts. */
  @FunctionalInterface
  public interface Format {

    /** Throws {@link WireFormatException} if {@code value} is malformed as that of this decree. */
    void checkValue(long number, Value value);

    /** Throws {@link WireFormatException} if {@code wish} is malformed; by default only empty is not. */
    default void checkWish(Value wish) {
      if (wish.length() > 0) {
        throw new WireFormatException("a wish where none is expected");
      }
    }

    /** A value is what {@code shape} reads; wishes are empty. */
    static Format of(Shape<?> shape) {
      return (number, value) -> value.read("a value", shape::read);
    }
  }

  /** {@code check} as a condition of a shape. */
  private static <T> Consumer<T> refusing(Consumer<T> check) {
    return value -> {
      try {
        check.accept(value);
      } catch (WireFormatException malformed) {
        throw new IllegalArgumentException(malformed.getMessage(), malformed);
      }
    };
  }
}
