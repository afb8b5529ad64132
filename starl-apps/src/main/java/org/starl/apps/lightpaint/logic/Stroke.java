package org.starl.apps.lightpaint.logic;

/**
 * What one robot paints in one go.
 *
 * @param number its place in the list of strokes, the same on every robot
 */
public record Stroke(int number, Polyline path, Ink ink) {}
