plugins {
    `java-library`
    id("maven-publish")
}

description = "Robots and deployments as processes on one machine or several"

dependencies {
    api(project(":starl-core"))
    api(project(":starl-core-input"))
    api(project(":starl-sim"))
    api(project(":starl-android-robot"))
    api(libs.jspecify)
    testImplementation(project(":starl-primitives"))
    testImplementation(project(":starl-apps"))
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}
