package org.starl.apps.hello.robot;

import org.starl.apps.AppFactory;
import org.starl.apps.Request;
import org.starl.apps.RobotProgram;
import org.starl.apps.hello.logic.Hello;

/** The smallest app: each robot drives one metre. */
public final class HelloFactory implements AppFactory {

  @Override
  public String name() {
    return "hello";
  }

  @Override
  public RobotProgram program(Request request) {
    return RobotProgram.of(Hello::new);
  }
}
