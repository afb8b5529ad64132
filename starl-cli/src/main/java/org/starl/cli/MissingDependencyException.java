package org.starl.cli;

/** This machine lacks something that a command needs, such as a display. Exit status 3. */
final class MissingDependencyException extends RuntimeException {

  private static final long serialVersionUID = 1;

  MissingDependencyException(String message) {
    super(message);
  }
}
