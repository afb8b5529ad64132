package org.starl.sim.view;

import java.awt.Color;
import javax.swing.UIManager;

/** Colours of the window's components, of the theme that is on. */
final class Tones {

  private static final double SELECTION = 0.22;

  private Tones() {}

  /** The most prominent colour: the current moment on the timeline, interventions. */
  static Color accent() {
    Color accent = UIManager.getColor("Component.accentColor");
    return accent == null ? new Color(0x2675BF) : accent;
  }

  /** The background of the selected robot; text keeps its colour on it. */
  static Color selection() {
    Color accent = accent();
    Color ground = UIManager.getColor("List.background");
    return new Color(
        mixed(ground.getRed(), accent.getRed()),
        mixed(ground.getGreen(), accent.getGreen()),
        mixed(ground.getBlue(), accent.getBlue()));
  }

  private static int mixed(int ground, int accent) {
    return (int) (ground + SELECTION * (accent - ground));
  }
}
