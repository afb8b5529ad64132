package org.starl.robot;

/**
 * Another machine runs this robot, or its storage is lost: this machine must not act as this robot. The
 * message is one line for people.
 */
public final class DisownedException extends RuntimeException {

  private static final long serialVersionUID = 1;

  DisownedException(String why) {
    super(why);
  }
}
