package org.starl.deploy.file;

/** A deployment file is not as it should be: one line for people names file, line, value and expected. */
public final class DeploymentException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  public DeploymentException(String message) {
    super(message);
  }
}
