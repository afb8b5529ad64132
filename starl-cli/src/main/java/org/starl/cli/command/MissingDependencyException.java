package org.starl.cli.command;

/** This machine lacks something that a command needs, such as a display. Exit status 3. */
public final class MissingDependencyException extends RuntimeException {

  private static final long serialVersionUID = 1;

  public MissingDependencyException(String message) {
    super(message);
  }
}
