package org.starl.lang.read;

import java.util.List;
import java.util.stream.Collectors;

/** A source is wrong; its message has a line for each error. */
public final class SourceErrors extends Exception {

  private static final long serialVersionUID = 1L;

  private final transient List<SourceError> errors;

  /**
   * @param errors at least one
   */
  public SourceErrors(List<SourceError> errors) {
    super(errors.stream().map(SourceError::toString).collect(Collectors.joining("\n")));
    this.errors = List.copyOf(errors);
  }

  /** In the order of the text; at least one. */
  public List<SourceError> errors() {
    return errors;
  }
}
