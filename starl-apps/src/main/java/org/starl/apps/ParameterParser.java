package org.starl.apps;

import java.util.function.Function;
import org.starl.input.BadInput;
import org.starl.input.Quantities;

/** Parses the values of an app's parameters. */
public final class ParameterParser {

  private ParameterParser() {}

  /**
   * The value of {@code parameter} in {@code request}.
   *
   * @param parser throws {@link BadInput} if it cannot use the text
   * @throws BadInput of the parser, with the parameter's key before the message
   */
  public static <T> T parse(Request request, Parameter parameter, Function<String, T> parser) {
    try {
      return parser.apply(request.parameter(parameter.key()));
    } catch (BadInput error) {
      throw Quantities.in(parameter.key(), error);
    }
  }
}
