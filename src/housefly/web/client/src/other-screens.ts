// What is beside the live scene, in one file: fetched when there is time, or when opened.
export { Invite } from "./device/invite";
export { EditScreen } from "./live/edit-screen";
export { TasksScreen } from "./tasks/tasks-screen";
